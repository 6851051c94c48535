import { globSync, readFileSync } from 'node:fs'
import { weightsOf } from '@botgarten/learning/neural-network'
import type { CardProgram } from '@botgarten/content'
import { networks } from '@botgarten/programs'
import { expect, test } from 'vitest'
import { unitScale } from '#drawing/track.ts'
import { coveredIn, drawnLayout, drawnOf, knobsIn, type DrawnNet, drawnNet } from './still-layout.ts'

const content = new URL('../../../../../content/', import.meta.url)
const files = globSync('cards/network/*/{start,solution}.json', { cwd: content }).sort()
const nets = files.flatMap((file) => {
  const { programs, brains } = JSON.parse(readFileSync(new URL(file, content), 'utf8')) as CardProgram
  return Object.values(programs)
    .flatMap(networks)
    .slice(0, 1)
    .map((net) => [file, drawnNet(net, weightsOf(brains[net.id]!, ''))] as const)
})

test.each(nets)('no weight covers another, a knob or a node: %s', (_, net) => {
  expect(coveredIn(net, drawnLayout(net))).toBe(0)
})

test.each(nets)('no knob covers another: %s', (_, net) => {
  expect(knobsIn(net, drawnLayout(net))).toBe(0)
})

const allAlike: DrawnNet = { counts: [2, 2], left: [0, 0], weights: [0.5, 0.5, 0.5, 0.5], scale: unitScale }

test('rows are as low as they can be', () => {
  const empty = drawnLayout({ ...allAlike, weights: [0, 0, 0, 0] })
  expect(drawnLayout(allAlike).stage.height).toBeGreaterThan(empty.stage.height)
  expect(empty.columns[0]![1]!.y - empty.columns[0]![0]!.y).toBe(88)
})

test('all nodes and the names beside them stand on the stage', () => {
  for (const [, net] of nets) {
    const { columns, stage, radius, labelWidth } = drawnLayout(net)
    for (const { x, y } of columns.flat()) {
      expect(x - radius - labelWidth).toBeGreaterThan(0)
      expect(x + radius + labelWidth).toBeLessThan(stage.width)
      expect(y > radius && y < stage.height - radius).toBe(true)
    }
  }
})

test('a large layer is summed up: its first two neurons, a free row, its last one', () => {
  const large: DrawnNet = {
    counts: [2, 3, 2],
    left: [0, 21, 0],
    weights: Array<number>(12).fill(0),
    scale: unitScale,
  }
  const ys = drawnLayout(large).columns[1]!.map(({ y }) => y)
  expect(ys[2]! - ys[1]!).toBe(2 * (ys[1]! - ys[0]!))
  expect(drawnOf([1, 2, 3, 4, 5, 6, 7])).toEqual([1, 2, 7])
  expect(drawnOf([1, 2, 3, 4, 5, 6])).toEqual([1, 2, 3, 4, 5, 6])
})
