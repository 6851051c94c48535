/** What the formulas count. */
export interface Counts {
  readonly sentences: number
  readonly words: number
  readonly syllables: number
  /** Words of three syllables and more. */
  readonly long: number
}

/**
 * 4. Wiener Sachtextformel: the grade a German text suits, from 4 (easy) to 15.
 * R. Bamberger, E. Vanecek: Lesen, Verstehen, Lernen, Schreiben. Jugend und Volk, Wien 1984.
 */
export const sachtext4 = ({ sentences, words, long }: Counts): number =>
  0.2656 * (words / sentences) + 0.2744 * ((100 * long) / words) - 1.693

/**
 * Flesch-Kincaid grade level of an English text. J. P. Kincaid, R. P. Fishburne, R. L. Rogers, B. S. Chissom:
 * Derivation of New Readability Formulas for Navy Enlisted Personnel. Research Branch Report 8-75, 1975.
 */
export const fleschKincaid = ({ sentences, words, syllables }: Counts): number =>
  0.39 * (words / sentences) + 11.8 * (syllables / words) - 15.59

/** Grade of a text in a language, or null where we know no formula, or there are too few words to tell (under 30). */
export function gradeOf(text: string, language: string): number | null {
  const syllablesOf = { de: syllablesGerman, en: syllablesEnglish }[language]
  if (!syllablesOf) return null
  const counts = countsOf(text, syllablesOf)
  if (counts.words < 30) return null
  return language === 'de' ? sachtext4(counts) : fleschKincaid(counts)
}

/** A line that ends without a mark (a heading, a line of a list) is a sentence too. Numbers are no words. */
export function countsOf(text: string, syllablesOf: (word: string) => number): Counts {
  const sentences = text.split(/[.!?:…]+(?=["“”»)]*(?:\s|$))|\n+/).map(wordsOf)
  const words = sentences.flat()
  const each = words.map(syllablesOf)
  return {
    sentences: sentences.filter(({ length }) => length > 0).length,
    words: words.length,
    syllables: each.reduce((sum, one) => sum + one, 0),
    long: each.filter((one) => one >= 3).length,
  }
}

const wordsOf = (sentence: string): string[] => sentence.match(/\p{L}+(?:['’-]\p{L}+)*/gu) ?? []

/** Groups of vowels, diphthongs as one: "bauen" and "neue" have two. */
export const syllablesGerman = (word: string): number => {
  const vowels = word.toLowerCase().replaceAll('qu', 'q')
  return Math.max(1, vowels.match(/aa|ee|oo|ai|ei|ay|ey|au|äu|eu|ie(?!n$)|[aeiouyäöü]/g)?.length ?? 0)
}

/** Groups of vowels, without what is silent at the end: make, makes, walked; not: table, needed, boxes. */
export function syllablesEnglish(word: string): number {
  const bare = word
    .toLowerCase()
    .replace(/['’]s$/, '')
    .replace(/(?<=[^laeiouy]|[aeiouy]l)e$|(?<![td])ed$|(?<![sxzcg]|sh|ch)es$/, '')
  return Math.max(1, bare.match(/[aeiouy]+/g)?.length ?? 0)
}
