import { anything, type Choice } from './choice.ts'
import { offered } from './offered.ts'

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
