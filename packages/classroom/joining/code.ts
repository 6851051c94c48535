import { codeWords, type CodeLanguage } from '@botgarten/content/codes'

const words = 4
/** Codes of older classes, valid until their class ends. */
const wordsBefore = 3
const telling = 4

/** Four different words for a new class: a repeated word would look like a mistake. `random`: that many random bytes. */
export function newCode(language: CodeLanguage, random: (bytes: number) => Uint8Array): string {
  const list = codeWords(language)
  const code = new Set<string>()
  while (code.size < words) {
    const bytes = random(2)
    // 1,024 words divide 65,536 evenly: all are equally likely.
    code.add(list[(bytes[0]! * 256 + bytes[1]!) % list.length]!)
  }
  return [...code].join(' ')
}

/**
 * The form in which codes are compared: of each word the first four letters, as in `kite-otte-plum-rose`. Takes any marks
 * between the words, as well as all of them in capitals. Null for what is not four words, or three as before.
 */
export function codeKey(text: string): string | null {
  const parts = text
    .normalize('NFKC')
    .toLowerCase()
    .split(/[^a-z]+/)
  const starts = parts.filter((part) => part !== '').map((part) => part.slice(0, telling))
  return starts.length === words || starts.length === wordsBefore ? starts.join('-') : null
}

/** Whether a code has as few words as those of older classes. */
export const isShortCode = (key: string): boolean => key.split('-').length === wordsBefore

/** The complete words of a code that is known by their first letters: `kite-otte-plum-rose` is kite, otter, plum, rose. */
export function wordsOfKey(key: string, language: CodeLanguage): readonly string[] {
  const list = codeWords(language)
  return key.split('-').map((start) => list.find((word) => word.startsWith(start)) ?? start)
}
