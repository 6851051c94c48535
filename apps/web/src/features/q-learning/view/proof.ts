import type { QTrace } from '@botgarten/learning/q-learning'
import { m } from '#words/message.ts'
import { number } from './messages.ts'

/** How a number of the table comes about, with its numbers to three places. */
export function linesOf(trace: QTrace, gamma: number): string[] {
  const { before, alpha, reward, bestNext, after } = trace
  const exact = (value: number) => number(value, 3)
  const facts = { before: exact(before), alpha: exact(alpha), reward: exact(reward), gamma: exact(gamma) }
  return [m['proof.q.rule'](), m['proof.q.sum']({ ...facts, best: exact(bestNext), after: exact(after) })]
}
