import { m, say } from '#words/say.ts'
import type { Flow } from './flow.ts'

/** Boxes that say all in one sentence. */
const short: ReadonlySet<string> = new Set(['place'])

export const wordOf = (id: string): string => say(`materials.flow.${id}`)
export const noteOf = (id: string): string | null => (short.has(id) ? null : wordOf(`${id}Note`))

/** Where a question leads, for who does not see its arrows. */
export const wordsAfter = (id: string, ways: Flow['ways']): string =>
  ways
    .flatMap(({ from, to, word }) =>
      from === id && word ? m['materials.flow.goesTo']({ word: wordOf(word), box: wordOf(to) }) : [],
    )
    .join(' ')

/** All that its boxes say, sentence by sentence, in the order of its rows. */
export const flowWords = ({ boxes }: Flow): readonly string[] =>
  boxes.flatMap(({ id }) => [wordOf(id), noteOf(id) ?? []].flat())
