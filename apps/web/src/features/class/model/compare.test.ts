import type { World } from '@botgarten/simulation'
import { describe, expect, test } from 'vitest'
import { closeUp } from './compare.ts'

type Seen = Pick<World, 'size' | 'robots' | 'obstacles'>
const at = (x: number, y: number) => ({ pose: { x, y, heading: 0 } })
const worldWith = (bo: object, ...things: readonly object[]) =>
  ({ size: { width: 600, height: 400 }, robots: [bo], obstacles: things }) as unknown as Seen

const shows = ({ left, top, width, height }: ReturnType<typeof closeUp>, x: number, y: number) =>
  x > left + 20 && x < left + width - 20 && 400 - y > top + 20 && 400 - y < top + height - 20

describe('a version of a project', () => {
  test('shows Bo with the thing beside it', () => {
    const part = closeUp(worldWith(at(450, 130), at(300, 200), at(60, 60)))
    expect(shows(part, 450, 130)).toBe(true)
    expect(shows(part, 300, 200)).toBe(true)
  })

  test('shows Bo where the nearest thing is far away', () => {
    const part = closeUp(worldWith(at(550, 350), at(60, 60)))
    expect(shows(part, 550, 350)).toBe(true)
    expect(part.width).toBeLessThanOrEqual(260)
  })

  test('shows nothing beyond the walls', () => {
    const { left, top, width, height } = closeUp(worldWith(at(10, 390)))
    expect([left, top]).toEqual([0, 0])
    expect(width).toBeLessThan(600)
    expect(height).toBeLessThan(400)
  })
})
