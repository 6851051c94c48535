import type { Template } from '../types.ts'
import { distanceNeuron, forever, motorNeuron, network, number, show, start } from './examples.ts'

export const remember: Template = { type: 'ai_nn_remember' }
export const practise = (rounds: number): Template => ({
  type: 'ai_nn_practise',
  values: { ROUNDS: number(rounds) },
})
export const forget = (what: 'EXAMPLES' | 'PRACTICE'): Template => ({
  type: 'ai_nn_forget',
  fields: { WHAT: what },
})
export const error: Template = { type: 'ai_nn_error' }

/** Start, these blocks, then forever a net of two eyes and two wheels. */
export const taught = (...rows: readonly Template[]): readonly Template[] => [
  start,
  ...rows,
  forever(
    network([distanceNeuron('2'), distanceNeuron('3')], [motorNeuron('C'), motorNeuron('B')]),
    show(error),
  ),
]
