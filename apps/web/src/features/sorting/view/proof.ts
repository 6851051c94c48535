import { inertiaByGroup } from '@botgarten/learning/k-means'
import { m } from '#words/message.ts'
import { pointsIn, type Work } from '../model/work.ts'
import { number } from './messages.ts'

/** How the sum of all distances comes about: what it adds, and what each group has to it. */
export function linesOf({ state, table, distance }: Work): string[] {
  const all = state?.inertia.at(-1)
  if (!state || all === undefined) return []
  const groups = inertiaByGroup(pointsIn(table), state)?.map((share) => number(share, 2)) ?? []
  const sum = [...(groups.length > 0 ? [groups.join(' + ')] : []), number(all, 2)].join(' = ')
  return [m[`proof.k-means.${distance}`](), sum]
}
