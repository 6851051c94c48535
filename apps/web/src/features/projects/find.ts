import type { Listed } from '#storage/projects.ts'

export type Order = 'time' | 'name'

/** From here on there is a field to search in. */
export const MANY = 8

const plain = (text: string) => text.normalize('NFKD').replace(/\p{M}/gu, '').toLocaleLowerCase()

/** What is called like the words, wherever they stand in its name, in the order asked for. */
export function findProjects(
  all: readonly Listed[],
  wanted: { readonly words: string; readonly order: Order; readonly locale: string },
  nameOf: (kept: Listed) => string,
): readonly Listed[] {
  const words = plain(wanted.words).split(/\s+/).filter(Boolean)
  const found = all.filter((one) => words.every((word) => plain(nameOf(one)).includes(word)))
  if (wanted.order === 'time') return found
  const { compare } = new Intl.Collator(wanted.locale, { numeric: true })
  return found.toSorted((a, b) => compare(nameOf(a), nameOf(b)))
}
