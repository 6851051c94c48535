import { atomsOf, type Atom } from './atoms.ts'
import { pairsOf, publishable, split, type Pair } from './pairs.ts'
import type { Answer, Chance } from './types.ts'

/** Two forms whose answers are compared child by child. */
export interface Comparison {
  readonly before: string
  readonly after: string
  readonly pairs: readonly Pair[]
}

/** What of all answers is published. It only ever grows. */
export interface Release {
  /** Newcomers that were published together: tables count whole batches. */
  readonly batches: readonly Atom[]
  /** The batches, split wherever pairs are published. */
  readonly atoms: readonly Atom[]
  readonly comparisons: readonly Comparison[]
}

export const nothingReleased: Release = { batches: [], atoms: [], comparisons: [] }

/** Forms as they follow each other: each is compared with all before it. */
const comparable = (forms: readonly string[]): readonly (readonly [string, string])[] =>
  forms.flatMap((before, at) => forms.slice(at + 1).map((after) => [before, after] as const))

/**
 * Publishes what may be published: newcomers of a form as soon as there are five of them, and pairs.
 * @param forms ids of the forms that are closed, in the order in which they are filled in
 */
export function released(
  previous: Release,
  answers: readonly Answer[],
  forms: readonly string[],
  chance: Chance,
): Release {
  const there = new Set(previous.batches.flatMap(({ ids }) => ids))
  const news = forms.flatMap((form) =>
    atomsOf(
      form,
      answers.filter((one) => one.form === form && !there.has(one.id)),
    ),
  )
  const begun: Release = {
    ...previous,
    batches: [...previous.batches, ...news],
    atoms: [...previous.atoms, ...news],
  }
  return comparable(forms).reduce((release, pair) => withPairs(release, answers, pair, chance), begun)
}

/** Adds the pairs of two forms that can be published beside those that are. */
function withPairs(
  release: Release,
  answers: readonly Answer[],
  [before, after]: readonly [string, string],
  chance: Chance,
): Release {
  const shown = new Set(release.batches.flatMap(({ ids }) => ids))
  const of = (form: string) => answers.filter((one) => one.form === form && shown.has(one.id))
  const old = release.comparisons.find((one) => one.before === before && one.after === after)
  const known = new Set(old?.pairs.flat())
  const fresh = pairsOf(of(before), of(after)).filter((pair) => !pair.some((id) => known.has(id)))
  const pairs = publishable(fresh, release.atoms, chance)
  if (pairs.length === 0) return release
  const next = { before, after, pairs: [...(old?.pairs ?? []), ...pairs] }
  return {
    ...release,
    atoms: split(release.atoms, pairs),
    comparisons: [...release.comparisons.filter((one) => one !== old), next],
  }
}
