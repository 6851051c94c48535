/** So many letters of a word are enough to know it. */
const telling = 4
/** Codes of older classes have one word less. */
export const codeLength = 4
const codeLengthBefore = 3

/** The words of a code that was typed or is in a link: at most four. */
export const wordsIn = (text: string): readonly string[] =>
  text
    .normalize('NFKC')
    .split(/[^\p{L}]+/u)
    .filter((word) => word !== '')
    .slice(0, codeLength)

/**
 * The code that the fields hold, in the form in which it is requested; null while a word is too short. The last field may be
 * empty: an older class has three words.
 */
export function codeOf(fields: readonly string[]): string | null {
  const all = fields.map((field) => field.trim().toLowerCase())
  const words = all.at(-1) === '' ? all.slice(0, -1) : all
  const fits = words.length === codeLength || words.length === codeLengthBefore
  return fits && words.every((word) => word.length >= telling) ? words.join(' ') : null
}

/** Whether the code is complete: the class is looked up at once. */
export const isComplete = (fields: readonly string[]): boolean =>
  fields.length === codeLength && fields.at(-1) !== '' && codeOf(fields) !== null

/** The code after the # of a link; null where there is none. Servers and their logs never see it. */
export function codeInLink(hash: string): readonly string[] | null {
  const words = wordsIn(decode(hash.replace(/^#/, '')))
  return codeOf(words) === null ? null : words
}

function decode(text: string): string {
  try {
    return decodeURIComponent(text)
  } catch {
    return text
  }
}

const [shortest, longest] = [2, 20]

/** A nickname as the class would take it: its length alone is looked at here. */
export function fitsAsNickname(text: string): boolean {
  const letters = [...text.normalize('NFKC').trim().replace(/ +/g, ' ')].length
  return letters >= shortest && letters <= longest
}
