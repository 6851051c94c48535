import { fewest, type Answer } from './types.ts'

/** Grades that are shown together, as the study of 2020 did, and those above. */
export const bands = ['3-4', '5-6', '7-9', '10-12'] as const
export type Band = (typeof bands)[number]

export const bandOf = (grade: number): Band =>
  grade <= 4 ? '3-4' : grade <= 6 ? '5-6' : grade <= 9 ? '7-9' : '10-12'

/** At least five people who answered a form, and of whom everything published counts all or none. */
export interface Atom {
  readonly form: string
  /** The grades among them, in order: more than one where one alone had fewer than five. */
  readonly bands: readonly Band[]
  /** Ids of their answers. */
  readonly ids: readonly string[]
}

const merged = (a: Atom, b: Atom): Atom => ({
  form: a.form,
  bands: bands.filter((band) => a.bands.includes(band) || b.bands.includes(band)),
  ids: [...a.ids, ...b.ids],
})

/** Merges what is smaller than five with the smaller of its neighbours, until nothing is. */
function allLargeEnough(atoms: readonly Atom[]): readonly Atom[] {
  const at = atoms.findIndex(({ ids }) => ids.length < fewest)
  if (at < 0 || atoms.length === 1) return atoms
  const size = (index: number) => atoms[index]?.ids.length ?? Infinity
  const first = size(at - 1) <= size(at + 1) ? at - 1 : at
  const both = merged(atoms[first]!, atoms[first + 1]!)
  return allLargeEnough([...atoms.slice(0, first), both, ...atoms.slice(first + 2)])
}

/** The atoms that newcomers of one form make; none while they are fewer than five. */
export function atomsOf(form: string, newcomers: readonly Answer[]): readonly Atom[] {
  if (newcomers.length < fewest) return []
  const perBand = bands.map((band): Atom => {
    const ids = newcomers.filter(({ grade }) => bandOf(grade) === band).map(({ id }) => id)
    return { form, bands: [band], ids }
  })
  return allLargeEnough(perBand.filter(({ ids }) => ids.length > 0))
}
