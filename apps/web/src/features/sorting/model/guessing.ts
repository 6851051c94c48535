import { bestOf, pointsOf, startAt, stepPhase } from '@botgarten/learning/k-means'
import type { ThingSet } from '@botgarten/content/things'
import { stream } from '@botgarten/numbers'
import { thingTable } from './work.ts'

/** Groups of things by these features, as lists of their places; the best of many starts, always the same. */
export function groupsBy(set: ThingSet, features: readonly string[], groups: number): number[][] {
  const points = pointsOf(thingTable(set, features).rows)
  const { labels } = bestOf(points, groups, {
    ...{ starts: 25, init: '++', distance: 'euclidean' },
    stream: stream(1, 'learn/sorting/guess'),
  })
  const order = [...new Set(labels)]
  return order.map((group) => labels.flatMap((label, thing) => (label === group ? [thing] : [])))
}

/** No sorting is shown longer. */
const MOST_ROUNDS = 8

/**
 * The sorting, round by round, from one thing of each group on: who is in which group after everything has gone to its
 * nearest flag. The last round is what `groupsBy` finds.
 */
export function roundsOf(set: ThingSet, features: readonly string[], groups: number): number[][][] {
  const { rows } = thingTable(set, features)
  const points = pointsOf(rows)
  const last = groupsBy(set, features, groups)
  const members = (labels: ArrayLike<number>) =>
    last.map((_, group) => Array.from(labels).flatMap((label, thing) => (label === group ? [thing] : [])))
  const rounds: number[][][] = []
  let state = startAt(
    points,
    last.map(([first]) => rows[first!]!),
  )
  while (state.phase !== 'done' && rounds.length < MOST_ROUNDS) {
    const isJoining = state.phase === 'assign'
    state = stepPhase(points, state)
    if (isJoining) rounds.push(members(state.labels))
  }
  return [...rounds, last].filter(
    (round, at, all) => at === 0 || JSON.stringify(round) !== JSON.stringify(all[at - 1]),
  )
}

/** `right`: these features · `alike`: others that give the same groups · `wrong`: how many of both were found. */
export type Verdict =
  | { readonly kind: 'right' }
  | { readonly kind: 'alike' }
  | { readonly kind: 'wrong'; readonly found: number; readonly of: number }

export function judge(
  set: ThingSet,
  secret: readonly string[],
  guess: readonly string[],
  groups: number,
): Verdict {
  const found = guess.filter((feature) => secret.includes(feature)).length
  if (found === secret.length && found === guess.length) return { kind: 'right' }
  const same = JSON.stringify(groupsBy(set, secret, groups)) === JSON.stringify(groupsBy(set, guess, groups))
  return same ? { kind: 'alike' } : { kind: 'wrong', found, of: secret.length }
}
