import type { Item } from '@botgarten/content/items'

/** Kinds that stand together, as somebody looks for them. */
export const shelves = {
  cards: ['card', 'observation'],
  slides: ['slides'],
  sheets: ['sheet', 'worksheet'],
  unplugged: ['kit'],
  plans: ['curriculum', 'checklist'],
  solutions: ['solution'],
  more: ['observer', 'links'],
} as const satisfies { readonly [shelf: string]: readonly Item['kind'][] }

export type Shelf = keyof typeof shelves

/** What somebody looks for in the library; what is not said leaves everything in. */
export interface Choice {
  readonly words: string
  readonly grade: number | null
  readonly modules: readonly number[]
  readonly shelves: readonly Shelf[]
  readonly ways: readonly Item['way'][]
  readonly socials: readonly Item['social'][]
  /** Minutes there are at most. */
  readonly minutes: number | null
  readonly teachers: boolean
}

export const anything: Choice = {
  ...{ words: '', grade: null, modules: [], shelves: [], ways: [], socials: [], minutes: null },
  teachers: true,
}

const among = <Value>(all: readonly Value[], value: Value) => all.length === 0 || all.includes(value)

const shelfOf = (kind: Item['kind']): Shelf =>
  (Object.keys(shelves) as Shelf[]).find((shelf) => shelves[shelf].some((one) => one === kind))!

/** Does an item fit? `title` is its name in the language of now; small and large letters are the same. */
export function fits(item: Item, title: string, choice: Choice): boolean {
  const { words, grade, modules, ways, socials, minutes, teachers } = choice
  return (
    title.toLowerCase().includes(words.trim().toLowerCase()) &&
    (grade === null || (item.grades[0] <= grade && grade <= item.grades[1])) &&
    among(modules, item.module) &&
    among(choice.shelves, shelfOf(item.kind)) &&
    // What belongs to all ways belongs to each of them.
    (item.way === 'all' || among(ways, item.way)) &&
    among(socials, item.social) &&
    (minutes === null || item.minutes <= minutes) &&
    (teachers || item.audience === 'pupils')
  )
}

/** The same list with a value in it, or without it. */
export const toggled = <Value>(all: readonly Value[], value: Value): readonly Value[] =>
  all.includes(value) ? all.filter((one) => one !== value) : [...all, value]
