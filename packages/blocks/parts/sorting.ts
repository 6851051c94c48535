import { bestOf, distancesOf, pointsOf } from '@botgarten/learning/k-means'
import type { Block, Context, SortingMemory } from '../types.ts'
import { sensorPortIn } from './fields.ts'

/** A colour sensor's reading: red, green and blue, 0..255. */
type Reading = readonly number[]

/** No program collects more; further readings take the places of the first. */
const MOST = 400
const STARTS = 10
export const MOST_GROUPS = 9

/** What the colour sensor at the block's port reads; null without one. */
export function readingAt(block: Block, { robot }: Context): Reading | null {
  const port = sensorPortIn(block, 'SENSORPORT')
  if (port === undefined) return null
  const reading = (['red', 'green', 'blue'] as const).map((mode) => robot.read(port, mode))
  return reading.every((value) => typeof value === 'number') ? reading : null
}

export function collect(memory: SortingMemory, reading: Reading): void {
  memory.readings[memory.collected % MOST] = reading
  memory.collected++
}

/**
 * k-means over what was collected, the best of ten starts, the same for the same readings. Groups are numbered in the order
 * in which the robot met them, so that a name stays with its colour when the robot drives again.
 */
export function findGroups(memory: SortingMemory, groups: number): void {
  const { labels, centres } = bestOf(pointsOf(memory.readings), groups, {
    ...{ starts: STARTS, init: '++', distance: 'euclidean' },
    // Always the same chance.
    stream: [1, 2, 3, 4],
  })
  memory.centres = [...new Set(labels)].map((label) => centres[label]!)
}

/** To every group's middle, in steps of the colours. */
export const distancesTo = ({ centres }: SortingMemory, reading: Reading): number[] =>
  distancesOf(pointsOf([reading]), 0, centres, 'euclidean')

/** The nearest group, from 0. */
export function groupOf(memory: SortingMemory, reading: Reading): number {
  const away = distancesTo(memory, reading)
  return away.indexOf(Math.min(...away))
}
