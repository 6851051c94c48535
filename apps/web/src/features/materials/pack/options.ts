/** How a pack is put together. */
export interface PackOptions {
  readonly children: number
  /** Answers lie behind everything, are in a file of their own, or are this file. */
  readonly answers: 'with' | 'apart' | 'only'
  /** Of the class: sheets with reading levels are those for it; null: those in the middle. */
  readonly grade: number | null
  /** All of it is printed so many times. */
  readonly sets: number
  /** In these languages; none: in the one that the page speaks. */
  readonly languages: readonly string[]
}

export const mostChildren = 99
export const mostSets = 20

/** Reads `?children=24&answers=with|apart|only&grade=4&sets=2&languages=de,en`; what cannot be is as usual. */
export function packOptionsIn(search: Pick<URLSearchParams, 'get'>): PackOptions {
  const answers = search.get('answers')
  const languages = search.get('languages')?.split(',') ?? []
  return {
    children: wholeOf(search.get('children'), mostChildren) ?? 24,
    grade: wholeOf(search.get('grade'), 13),
    sets: wholeOf(search.get('sets'), mostSets) ?? 1,
    languages: [...new Set(languages)],
    answers: answers === 'apart' || answers === 'only' ? answers : 'with',
  }
}

/** A whole number from 1 to `most`; null for what is none. */
function wholeOf(text: string | null, most: number): number | null {
  const number = Number(text ?? 0)
  return Number.isInteger(number) && number >= 1 && number <= most ? number : null
}
