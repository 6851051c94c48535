import type { Item } from '@botgarten/content/items'

/** Kinds that stand together, as somebody looks for them. */
const shelves = {
  plans: ['plan', 'curriculum', 'checklist'],
  cards: ['card', 'observation'],
  sheets: ['sheet', 'worksheet'],
  slides: ['slides'],
  unplugged: ['kit'],
  solutions: ['solution'],
  more: ['observer', 'links'],
} as const satisfies { readonly [shelf: string]: readonly Item['kind'][] }

export type Shelf = keyof typeof shelves

/** Shelves an item stands on: what needs no screen stands on two. */
export const shelvesOf = ({ kind, unplugged, audience }: Item): readonly Shelf[] =>
  (Object.keys(shelves) as Shelf[]).filter(
    (shelf) =>
      shelves[shelf].some((one) => one === kind) ||
      (shelf === 'unplugged' && unplugged && audience === 'pupils'),
  )

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

/** Does an item fit, whatever its words are? */
export function fits(item: Item, choice: Choice): boolean {
  const { grade, modules, ways, socials, minutes, teachers } = choice
  return (
    (grade === null || (item.grades[0] <= grade && grade <= item.grades[1])) &&
    among(modules, item.module) &&
    (choice.shelves.length === 0 || shelvesOf(item).some((shelf) => choice.shelves.includes(shelf))) &&
    among(ways, item.way) &&
    among(socials, item.social) &&
    (minutes === null || item.minutes <= minutes) &&
    (teachers || item.audience === 'pupils')
  )
}

/** The same list with a value in it, or without it. */
export const toggled = <Value>(all: readonly Value[], value: Value): readonly Value[] =>
  all.includes(value) ? all.filter((one) => one !== value) : [...all, value]

/** What can be chosen from. */
export const offered = {
  grades: [3, 4, 5, 6, 7, 8, 9, 10, 11, 12],
  modules: [1, 2, 3, 4],
  shelves: Object.keys(shelves) as Shelf[],
  ways: ['supervised', 'reinforcement', 'unsupervised'],
  socials: ['alone', 'pairs', 'groups', 'class'],
  times: [20, 45, 90],
} as const

/** What is written of a choice into the page's address, by its name there. */
const lists = { module: 'modules', kind: 'shelves', way: 'ways', social: 'socials' } as const
const numbers = { grade: 'grades', minutes: 'times' } as const

/** A choice as the end of an address: `?kind=cards,sheets&module=2`; empty where everything fits. */
export function queryOf(choice: Choice): string {
  const parts: readonly (readonly [string, string])[] = [
    ['q', choice.words.trim()],
    ...Object.entries(lists).map(([name, list]) => [name, choice[list].join(',')] as const),
    ...Object.keys(numbers).map(
      (name) => [name, String(choice[name as keyof typeof numbers] ?? '')] as const,
    ),
    ['teachers', choice.teachers ? '' : 'no'],
  ]
  const said = parts.filter(([, value]) => value !== '')
  return said.length === 0
    ? ''
    : `?${new URLSearchParams(said.map((one) => [...one])).toString().replaceAll('%2C', ',')}`
}

/** The choice an address keeps; what cannot be chosen is left out. */
export function choiceIn(query: Pick<URLSearchParams, 'get'>): Choice {
  const some = <Value>(name: string, all: readonly Value[]): readonly Value[] => {
    const said = query.get(name)?.split(',') ?? []
    return all.filter((one) => said.includes(String(one)))
  }
  const one = (name: keyof typeof numbers) => some<number>(name, offered[numbers[name]])[0] ?? null
  return {
    words: query.get('q') ?? anything.words,
    modules: some('module', offered.modules),
    shelves: some('kind', offered.shelves),
    ways: some('way', offered.ways),
    socials: some('social', offered.socials),
    grade: one('grade'),
    minutes: one('minutes'),
    teachers: query.get('teachers') !== 'no',
  }
}
