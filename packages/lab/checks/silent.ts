import { heldFor, nameOf, tooShort, type Kind } from './kind.ts'
import { colourUnder, robotIn } from './moment.ts'

interface Memory {
  held: number
  longest: number
  /** What stood on the display when `colour` was seen last; null while it has not been. */
  word: string | null
  done: boolean
}

/** On `colour` no word stands on the display for `seconds` without a break; it stays passed. */
export const silent: Kind<Memory> = {
  needs: ['colour'],
  lacks: ['unseen', 'spoke', 'short'],
  begin: () => ({ held: 0, longest: 0, word: null, done: false }),
  observe(check, moment, memory) {
    const sees = colourUnder(moment) === nameOf(check, 'colour')
    const word = robotIn(moment).display.find((row) => /[\p{L}\p{N}]/u.test(row)) ?? ''
    if (sees) memory.word = word
    memory.done = heldFor(check, memory, sees && word === '') || memory.done
    return memory.done
  },
  missing(check, { word, longest }) {
    const colour = nameOf(check, 'colour')
    if (word === null) return { what: 'unseen', facts: { colour } }
    return word === '' ? tooShort(check, longest, { colour }) : { what: 'spoke', facts: { colour, word } }
  },
}
