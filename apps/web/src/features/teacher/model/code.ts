import type { SchoolClass } from './answers.ts'

/** The words of a class's code, as they are shown. */
export const wordsOf = ({ words }: Pick<SchoolClass, 'words'>): readonly string[] => words

/** All of them in a line: "kite otter plum rope". */
export const codeLabel = (school: Pick<SchoolClass, 'words'>): string => wordsOf(school).join(' ')

/** A word in two parts: what is enough to type, and the rest. */
export const telling = (word: string): readonly [string, string] => [word.slice(0, 4), word.slice(4)]

/** Where pupils join: the code stands behind the #, which no server ever sees. */
export const joinAddress = (origin: string, school: Pick<SchoolClass, 'words'>): string =>
  `${origin}/join#${wordsOf(school).join('-')}`
