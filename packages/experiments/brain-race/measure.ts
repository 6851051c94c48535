import type { Check, Lab } from '@botgarten/lab'
import type { Measure } from './types.ts'

/** More laps than any robot drives. */
const endless = 1000

/** The lab's own checks say what a course measures. */
export function checksFor(measure: Measure, seconds: number): readonly Check[] {
  if (measure.kind === 'time')
    return [{ id: 'near', kind: 'near', numbers: { obstacle: measure.obstacle, cm: measure.cm }, seconds }]
  if (measure.kind === 'laps') {
    const gates = measure.gates.map(({ x, y }) => `${x} ${y}`).join(', ')
    return [{ id: 'laps', kind: 'laps', numbers: { gates, cm: measure.cm, laps: endless }, seconds }]
  }
  return []
}

/** What a run has come to. `cm`: its way in a minute. */
export function scoreOf(measure: Measure, lab: Lab, cm: number, seconds: number): number {
  if (measure.kind === 'way') return cm
  if (measure.kind === 'time') return lab.view().checks[0]?.at ?? seconds
  return Number(lab.missing()[0]?.facts['passed'] ?? 0) / measure.gates.length
}

/** Of a run in which nothing moved. */
export const worstOf = ({ kind }: Measure, seconds: number): number => (kind === 'time' ? seconds : 0)

/** Is less of it better? */
export const isLess = ({ kind }: Measure): boolean => kind === 'time'
