import { describe, expect, test } from 'vitest'
import { changes } from './changes.ts'
import type { Command, Group } from './commands.ts'

const dot: Command = { kind: 'circle', x: 0, y: 0, r: 5, fill: '#000' }
const links: Group = { kind: 'group', still: { x: 0, y: 0, width: 400, height: 300 }, shapes: [dot] }
const look: readonly Command[] = [dot]
const pulse = (x: number, y: number): Group => ({
  kind: 'group',
  x,
  y,
  still: { x: -6, y: -6, width: 12, height: 12 },
  shapes: look,
})

describe('what is painted again', () => {
  test('is nothing where everything stays', () => {
    expect(changes([links, pulse(10, 20)], [links, pulse(10, 20)])).toEqual([])
  })

  test('is where a picture was and where it is', () => {
    const found = changes([links, pulse(10, 20)], [links, pulse(13, 20)])
    expect(found).toMatchObject([
      { x: 4, y: 14, width: 12, height: 12 },
      { x: 7, y: 14, width: 12, height: 12 },
    ])
  })

  test('is a picture of other shapes, and one that is paler', () => {
    const other: Group = { ...links, shapes: [dot, dot] }
    expect(changes([links], [other])).toMatchObject([links.still!, other.still!])
    const pale = (opacity: number): Group => ({ kind: 'group', opacity, shapes: [links] })
    expect(changes([pale(1)], [pale(0.5)])).toHaveLength(2)
  })

  test('lies where the groups around it take it', () => {
    const inside = (x: number): Group => ({ kind: 'group', x: 100, shapes: [pulse(x, 0)] })
    expect(changes([inside(0)], [inside(1)])![1]).toMatchObject({ x: 95, y: -6 })
  })

  test('is all where a shape has no picture, one is turned or scaled, or one more is there', () => {
    expect(changes([links], [links, dot])).toBeNull()
    expect(changes([dot], [dot])).toBeNull()
    expect(changes([{ ...links, turn: 3 }], [links])).toBeNull()
    expect(changes([{ ...links, scale: 2 }], [links])).toBeNull()
    expect(changes([links], [links, pulse(0, 0)])).toBeNull()
  })
})
