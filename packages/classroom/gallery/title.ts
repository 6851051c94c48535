const longest = 60

/** What is never seen and can turn a line of text around. */
const unseen = /[\p{Cc}\p{Zl}\p{Zp}\u200e\u200f\u202a-\u202e\u2066-\u2069\ufeff]/gu
/** A letter with so many marks covers the lines around it. */
const towers = /(\p{M}{2})\p{M}+/gu

/** A title as it is shown: one line, 1 to 60 letters. Null for what is none. */
export function titleFrom(text: string): string | null {
  const title = text.normalize('NFC').replace(unseen, ' ').replace(towers, '$1').replace(/\s+/gu, ' ').trim()
  const letters = [...title].length
  return letters >= 1 && letters <= longest && /[^\p{M}\p{Cf}\s]/u.test(title) ? title : null
}
