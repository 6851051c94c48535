import type { Atom } from './atoms.ts'
import { shuffled } from './shuffle.ts'
import { fewest, type Answer, type Chance } from './types.ts'

/** Ids of what one child answered earlier and later. */
export type Pair = readonly [before: string, after: string]

/** By code the one answer that has it; a code that stands there twice is nobody's. */
function byCode(answers: readonly Answer[]): ReadonlyMap<string, Answer> {
  const found = new Map<string, Answer>()
  const twice = new Set<string>()
  for (const answer of answers) {
    if (answer.code === null) continue
    if (found.has(answer.code)) twice.add(answer.code)
    found.set(answer.code, answer)
  }
  for (const code of twice) found.delete(code)
  return found
}

/** What the same code answered to two forms. */
export function pairsOf(before: readonly Answer[], after: readonly Answer[]): readonly Pair[] {
  const later = byCode(after)
  return [...byCode(before)].flatMap(([code, { id }]): Pair[] => {
    const match = later.get(code)
    return match ? [[id, match.id]] : []
  })
}

/** Ids that are to be left out so that the atom falls into pieces of none or at least five. */
function toLeaveOut({ ids }: Atom, inside: readonly string[], chance: Chance): readonly string[] {
  const outside = ids.length - inside.length
  const lacking = outside === 0 || outside >= fewest ? 0 : fewest - outside
  const left = inside.length - lacking
  if (inside.length === 0 || (lacking === 0 && left >= fewest)) return []
  return left < fewest ? inside : shuffled(inside, chance).slice(0, lacking)
}

/** As many of the pairs as can be published: none of the pieces into which they split an atom is smaller than five. */
export function publishable(pairs: readonly Pair[], atoms: readonly Atom[], chance: Chance): readonly Pair[] {
  let left = pairs
  for (;;) {
    const there = new Set(left.flat())
    const out = atoms
      .map((atom) =>
        toLeaveOut(
          atom,
          atom.ids.filter((id) => there.has(id)),
          chance,
        ),
      )
      .find((ids) => ids.length > 0)
    if (!out) return left
    left = left.filter((pair) => !pair.some((id) => out.includes(id)))
  }
}

/** The atoms once pairs are published: each is split into who is among them and who is not. */
export const split = (atoms: readonly Atom[], pairs: readonly Pair[]): readonly Atom[] => {
  const there = new Set(pairs.flat())
  return atoms.flatMap((atom) =>
    [atom.ids.filter((id) => there.has(id)), atom.ids.filter((id) => !there.has(id))]
      .filter((ids) => ids.length > 0)
      .map((ids) => ({ ...atom, ids })),
  )
}
