import { content } from '@botgarten/content/files'
import { bestOf, pointsOf } from '@botgarten/learning/k-means'
import { describe, expect, test } from 'vitest'
import { createRover, type Reading } from './rover.ts'

const rover = (seed: number) => createRover(content.world('tiles')!, seed)

describe('Bo on its colourful floor', () => {
  test.each([1, 2, 3, 4, 5])(
    'by itself comes over all colours, and k-means finds three (seed %i)',
    (seed) => {
      const readings = rover(seed).advance(3000, 'lanes')
      expect(readings.length).toBeGreaterThan(100)
      const { labels, centres } = bestOf(pointsOf(readings), 3, {
        ...{ starts: 10, init: '++', distance: 'euclidean' },
        stream: [1, 2, 3, 4],
      })
      for (const group of centres.keys())
        expect(labels.filter((label) => label === group).length).toBeGreaterThan(readings.length / 10)
      const reds = centres.map(([red]) => red!).toSorted((a, b) => a - b)
      expect(reds[0]!).toBeLessThan(130)
      expect(reds[1]!).toBeGreaterThan(180)
    },
  )

  test('by itself turns the short way, round after round: it never spins', () => {
    const bo = rover(1)
    let before = bo.pose().heading
    let turned = 0
    for (let second = 0; second < 300; second += 1) {
      bo.advance(60, 'lanes')
      const by = ((bo.pose().heading - before + 540) % 360) - 180
      before = bo.pose().heading
      // A lane between two turns ends the one before.
      turned = Math.abs(by) < 1 ? 0 : turned + by
      expect(Math.abs(turned)).toBeLessThan(300)
    }
  })

  test('is driven by hand, and stands when nobody drives', () => {
    const bo = rover(1)
    const { x } = bo.pose()
    expect(bo.advance(36, 'forward')).toHaveLength(2)
    expect(bo.pose().x).toBeGreaterThan(x)
    const stood = bo.pose()
    expect(bo.advance(60, null)).toEqual([])
    expect(bo.pose()).toEqual(stood)
    bo.advance(20, 'left')
    expect(bo.pose().heading).toBeGreaterThan(stood.heading)
  })

  test('reads the same with the same seed, and otherwise with another', () => {
    const drive = (seed: number): readonly Reading[] => rover(seed).advance(400, 'lanes')
    expect(drive(3)).toEqual(drive(3))
    expect(drive(3)).not.toEqual(drive(4))
  })
})
