import { heldFor, nameOf, tooShort, type Kind } from './kind.ts'
import { colourUnder, robotIn } from './moment.ts'

interface Memory {
  held: number
  longest: number
  /** What stood on the display last on `colour` and on each of `others`, by colour. */
  said: { [colour: string]: string }
  /** How many words stood there when `colour` was seen last; null while it has not been. */
  words: number | null
  done: boolean
}

/**
 * On `colour` the display shows one word for `seconds` without a break, and not the one that it has shown on a colour of
 * `others` ("#RRGGBB,…"); it stays passed.
 */
export const says: Kind<Memory> = {
  needs: ['colour', 'others'],
  lacks: ['unseen', 'silent', 'many', 'same', 'short'],
  begin: () => ({ held: 0, longest: 0, said: {}, words: null, done: false }),
  observe(check, moment, memory) {
    const [colour, others] = [nameOf(check, 'colour'), nameOf(check, 'others').split(',')]
    const sees = colourUnder(moment)
    const words = robotIn(moment).display.filter((row) => /[\p{L}\p{N}]/u.test(row))
    if (sees === colour) memory.words = words.length
    if (sees !== null && others.includes(sees)) memory.said[sees] = words.join(' ')
    const speaks = sees === colour && words.length === 1
    if (heldFor(check, memory, speaks)) memory.said[colour] = words[0]!
    const word = memory.said[colour]
    memory.done ||= word !== undefined && others.every((other) => (memory.said[other] ?? word) !== word)
    return memory.done
  },
  missing(check, { said, words, longest }) {
    const colour = nameOf(check, 'colour')
    const word = said[colour]
    const other = Object.keys(said).find((one) => one !== colour && said[one] === word)
    if (words === null) return { what: 'unseen', facts: { colour } }
    if (word !== undefined) return { what: 'same', facts: { colour, other: other ?? colour } }
    if (words !== 1) return { what: words === 0 ? 'silent' : 'many', facts: { colour, words } }
    return tooShort(check, longest, { colour })
  },
}
