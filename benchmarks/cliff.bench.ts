import { content } from '@botgarten/content/files'
import { pointsOf, runLane, type Race } from '@botgarten/experiments/race'
import reference from '../packages/experiments/reference/cliff.json' with { type: 'json' }
import type { Table } from './bench.ts'

const runs = 200
const tries = reference.episodes

const { map, start, goal, goalReward, stepCost } = content.mapFile('cliff')!

/** Sum of rewards a try, mean of all runs, in ten blocks of 50 tries. */
function rewardsOf(racer: 'q' | 'sarsa'): number[] {
  const lane = { racer, alpha: 0.5, gamma: 1, nu: 0, rho: 0.1 }
  const race: Race = {
    task: { map, start: start!, goal: goal!, goalReward: goalReward!, stepCost: stepCost! },
    ...{ lanes: [lane, lane], tries, runs, seed: 2026 },
  }
  const points = pointsOf(tries)
  const ends = Array.from({ length: 11 }, (_, block) => points.indexOf(50 * block))
  const sums = ends.map(() => 0)
  for (let run = 1; run <= runs; run++) {
    const { stars } = runLane(race, 1, run)
    ends.forEach((at, block) => (sums[block]! += at < 0 ? 0 : stars[at]!))
  }
  return sums.slice(1).map((sum, block) => (sum - sums[block]!) / runs / 50)
}

const said = (value: number) => value.toFixed(1)

/** The cliff of Sutton & Barto, example 6.6: what Q-learning and SARSA get while they learn. */
export default function cliff(): Table {
  const [q, sarsa] = [rewardsOf('q'), rewardsOf('sarsa')]
  return {
    title: 'Q-learning and SARSA on the cliff',
    how: `Sum of rewards during a try, mean of ${runs} runs; Sutton & Barto, 2nd edition, example 6.6: α 0.5, γ 1, ε 0.1.`,
    columns: ['tries', 'Q-learning', 'NumPy', 'SARSA', 'NumPy'],
    rows: q.map((value, block) => [
      `${50 * block + 1} to ${50 * block + 50}`,
      said(value),
      said(reference.q.returns.mean[block]!),
      said(sarsa[block]!),
      said(reference.sarsa.returns.mean[block]!),
    ]),
    notes: [
      'The figure of the book: after the first tries SARSA stays near −25, Q-learning near −50: it walks along the edge and falls.',
      `NumPy: a loop of its own, ${reference.runs} runs, packages/experiments/reference/cliff.py.`,
    ],
  }
}
