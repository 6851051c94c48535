import { draw, type StreamState } from '@botgarten/numbers'
import type { QTable, Settings } from './types.ts'

export const emptyTable = (states: number, actions: number): QTable => ({
  q: Array.from({ length: states * actions }, () => 0),
  tries: Array.from({ length: states * actions }, () => 0),
  moves: 0,
})

/** What ρ has fallen to after so many moves: in a straight line to 0.3 of its beginning. */
export const rhoAt = ({ rho, fall }: Settings, moves: number): number =>
  rho * (1 - 0.7 * Math.min(1, moves / fall))

/** One of the actions that are worth most; of several by a draw. */
export function bestAction(
  q: readonly number[],
  state: number,
  actions: number,
  stream: StreamState,
): number {
  const first = state * actions
  let best = first
  let ties = 1
  for (let other = first + 1; other < first + actions; other++)
    if (q[other]! > q[best]!) {
      best = other
      ties = 1
    } else if (q[other] === q[best]) ties++
  if (ties === 1) return best - first
  let skip = Math.floor(draw(stream) * ties)
  for (let other = best; ; other++) if (q[other] === q[best] && skip-- === 0) return other - first
}

/** An action: any one with probability `epsilon`, else a best one. Draws: ε always, then the action where it takes one. */
export function chooseAction(
  q: readonly number[],
  state: number,
  actions: number,
  epsilon: number,
  stream: StreamState,
): { readonly action: number; readonly explores: boolean } {
  const explores = draw(stream) < epsilon
  const action = explores ? Math.floor(draw(stream) * actions) : bestAction(q, state, actions, stream)
  return { action, explores }
}

interface Move {
  readonly from: number
  readonly action: number
  readonly reward: number
  readonly to: number
  /** Nothing is worth anything behind it. */
  readonly ends: boolean
}

/** The update of one move, in place: that of the maps (q-learning/model.md). */
export function learn(table: QTable, actions: number, settings: Settings, move: Move) {
  const { q, tries } = table
  const at = move.from * actions + move.action
  const bestNext = move.ends ? 0 : bestValue(q, move.to, actions)
  const count = (tries[at] = tries[at]! + 1)
  const alpha = settings.alphaDecay === 'visits' ? (settings.alpha * 10) / (9 + count) : settings.alpha
  const before = q[at]!
  const after = (1 - alpha) * before + alpha * (move.reward + settings.gamma * bestNext)
  q[at] = after
  table.moves++
  return { before, bestNext, after, alpha }
}

function bestValue(q: readonly number[], state: number, actions: number): number {
  const end = (state + 1) * actions
  let best = q[state * actions]!
  for (let other = state * actions + 1; other < end; other++) if (q[other]! > best) best = q[other]!
  return best
}
