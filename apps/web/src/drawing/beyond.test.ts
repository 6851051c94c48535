import type { View } from '@botgarten/lab'
import { describe, expect, test } from 'vitest'
import { drawBeyond } from './beyond.ts'

const floor = { width: 600, height: 400 }
const seen = { x: 100, y: 50, width: 500, height: 200 }
/** Signs for robots at these places, in px from the upper left corner of the floor. */
const signs = (...places: readonly (readonly [number, number])[]) => {
  const robots = places.map(([x, y], index) => ({ id: `r${index}`, pose: { x, y: 400 - y, heading: 0 } }))
  const view = { robots } as unknown as View
  return drawBeyond({ view, things: [], floor, scale: 1, colours: ['#F28C45', '#5AA9DE'], seen })
}

describe('robots beyond the edge', () => {
  test('one that is seen has no sign', () => {
    expect(signs([101, 51], [350, 150], [599, 249])).toEqual([])
  })

  test('a sign stands at the edge on the way to its robot, and points at it', () => {
    const [above] = signs([350, -400])
    expect(above).toMatchObject({ kind: 'group', x: 350, y: 80 })
    const [corner] = signs([900, 900])
    expect(corner).toMatchObject({ x: 570, y: 220 })
    expect(signs([-50, 0])[0]).toMatchObject({ x: 190, y: 80 })
    const arrow = (above as { shapes: readonly { points?: readonly { x: number; y: number }[] }[] })
      .shapes[0]!
    expect(arrow.points![1]).toEqual({ x: 0, y: -27 })
  })

  test('a thing has a sign where none of them is seen: the nearest one, small', () => {
    const at = (x: number, y: number) => ({
      pose: { x, y: 400 - y, heading: 0 },
      thing: { id: 'square', shape: { kind: 'rectangle', width: 50, height: 50 }, colour: 'blue' } as never,
    })
    const view = { robots: [{ id: 'bo', pose: { x: 350, y: 250, heading: 0 } }] } as unknown as View
    const draw = (...things: ReturnType<typeof at>[]) =>
      drawBeyond({ view, things, floor, scale: 1, colours: ['#F28C45'], seen })
    expect(draw(at(350, 390), at(20, 390))).toMatchObject([{ kind: 'group', x: 350, y: 220 }])
    expect(draw(at(350, 260), at(20, 390))).toEqual([])
    expect(draw()).toEqual([])
  })
})
