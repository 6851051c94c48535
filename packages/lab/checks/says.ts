import { heldFor, nameOf, type Kind } from './kind.ts'
import { colourUnder, robotIn } from './moment.ts'

interface Memory {
  held: number
  /** What stood on the display last on `colour` and on each of `others`, by colour. */
  said: { [colour: string]: string }
  done: boolean
}

/**
 * On `colour` the display shows one word for `seconds` without a break, and not the one that it has shown on a colour of
 * `others` ("#RRGGBB,…"); it stays passed.
 */
export const says: Kind<Memory> = {
  needs: ['colour', 'others'],
  begin: () => ({ held: 0, said: {}, done: false }),
  observe(check, moment, memory) {
    const [colour, others] = [nameOf(check, 'colour'), nameOf(check, 'others').split(',')]
    const sees = colourUnder(moment)
    const words = robotIn(moment).display.filter((row) => /[\p{L}\p{N}]/u.test(row))
    if (sees !== null && others.includes(sees)) memory.said[sees] = words.join(' ')
    const speaks = sees === colour && words.length === 1
    if (heldFor(check, memory, speaks)) memory.said[colour] = words[0]!
    const word = memory.said[colour]
    memory.done ||= word !== undefined && others.every((other) => (memory.said[other] ?? word) !== word)
    return memory.done
  },
}
