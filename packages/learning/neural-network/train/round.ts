import { fastDraw } from '@botgarten/numbers'
import { meanLoss } from './errors.ts'
import type { Practice } from './types.ts'

/** No knob of a child or of a good practice is as large. */
const FARTHEST = 1000

/** The order of the coming round: that of the table, or shuffled (Fisher & Yates; Durstenfeld 1964). */
export function beginRound({ settings, order, stream, drawn }: Practice): void {
  drawn.set(stream)
  for (let k = 0; k < order.length; k++) order[k] = k
  if (settings.order === 'table') return
  for (let k = order.length - 1; k > 0; k--) {
    const other = Math.floor(fastDraw(stream) * (k + 1))
    const row = order[k]!
    order[k] = order[other]!
    order[other] = row
  }
}

/** A round is whole: it counts, unless its steps were too big. */
export function finishRound(practice: Practice): void {
  const { parameters, whole, settings } = practice
  practice.at = 0
  if (hasRunAway(parameters)) {
    parameters.set(whole)
    practice.ended = { kind: 'ranAway', round: practice.round }
    return
  }
  whole.set(parameters)
  practice.round++
  if (settings.patience > 0) noteBest(practice)
  if (practice.ended === null && practice.round >= settings.rounds) practice.ended = { kind: 'rounds' }
  if (practice.ended === null) beginRound(practice)
}

function hasRunAway(parameters: Float64Array): boolean {
  for (let k = 0; k < parameters.length; k++) if (!(Math.abs(parameters[k]!) <= FARTHEST)) return true
  return false
}

/** Early stopping (Prechelt 1998): the best round of the test is beaten by one that is better by 1 %. */
function noteBest(practice: Practice): void {
  const { parameters, best, kept, settings } = practice
  const error = meanLoss(practice, kept)
  if (error === null) return
  if (error < 0.99 * practice.bestError) {
    practice.bestError = error
    practice.bestRound = practice.round
    best.set(parameters)
  } else if (practice.round - practice.bestRound >= settings.patience) {
    parameters.set(best)
    practice.ended = { kind: 'noBetter', best: practice.bestRound }
  }
}
