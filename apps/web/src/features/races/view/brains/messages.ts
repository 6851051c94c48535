import type { LaneKind, Measure, NotReady } from '@botgarten/experiments/brain-race'
import { m, message } from '#words/message.ts'
import type { Line } from '../../model/brains/lines.ts'
import { number } from '../messages.ts'

export const courseName = (world: string): string => message(`worldName.${world}`)

export const laneName = (kind: LaneKind): string => m[`race.brains.lane.${kind}`]()

/** How a brain of this lane comes about. */
export const laneText = (kind: LaneKind): string => m[`race.brains.laneText.${kind}`]()

export const notReady = (problem: NotReady): string => m[`race.brains.notReady.${problem}`]()

export const lineName = (id: Line['id'], { kind }: Measure): string =>
  id === 'score' ? m[`race.brains.measure.${kind}`]() : m[`race.brains.lines.${id}`]()

/** What is written small under the name of a line. */
export function lineUnit(id: Line['id'], { kind }: Measure): string {
  if (id === 'score') return m[`race.brains.unit.${kind}`]()
  return id === 'hand' || id === 'computer' ? m[`race.brains.unit.${id}`]() : ''
}

/** Lines whose numbers are no whole ones. */
const fine: readonly Line['id'][] = ['hand', 'computer']

export function valueSaid({ id }: Line, value: number | null, { kind }: Measure): string {
  if (value === null) return '–'
  return number(value, fine.includes(id) || (id === 'score' && kind !== 'way') ? 1 : 0)
}

export const unitSaid = (unit: NonNullable<NonNullable<Line['units']>[number]>): string =>
  m[`race.brains.tries.${unit}`]()
