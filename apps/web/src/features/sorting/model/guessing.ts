import { bestOf, pointsOf } from '@botgarten/learning/k-means'
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
