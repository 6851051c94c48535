/** So many letters of a word are enough to know it. */
const telling = 4

/** The words of a code as somebody types or a link holds them: at most three. */
export const wordsIn = (text: string): readonly string[] =>
  text
    .normalize('NFKC')
    .split(/[^\p{L}]+/u)
    .filter((word) => word !== '')
    .slice(0, 3)

/** The code that three fields hold, in the form in which it is asked for; null while one is too short. */
export function codeOf(fields: readonly string[]): string | null {
  const words = fields.map((field) => field.trim().toLowerCase())
  return words.length === 3 && words.every((word) => word.length >= telling) ? words.join(' ') : null
}

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
