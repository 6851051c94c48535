const shortest = 2
const longest = 20

/** A nickname as it is shown: NFKC, single spaces. Null for what is none: 2 to 20 letters, digits and spaces. */
export function nicknameFrom(text: string): string | null {
  const name = text.normalize('NFKC').trim().replace(/ +/g, ' ')
  const letters = [...name].length
  if (letters < shortest || letters > longest) return null
  // A letter may carry the marks that its script writes above or below it, at most two.
  return /^(?:[\p{L}\p{Nd}]\p{M}{0,2}| )+$/u.test(name) && /\p{L}|\p{Nd}/u.test(name) ? name : null
}

/** Two nicknames of a class must not have the same key. Upper case first: it takes ß and SS for the same. */
export const nicknameKey = (nickname: string): string =>
  nickname.normalize('NFKC').toUpperCase().toLowerCase().normalize('NFKC')
