import { learningIn } from '@botgarten/programs'
import type { ContentFiles } from '../files.ts'
import { triesOf, type TriesRow } from './tries.ts'

export type { TriesRow }

/** What answers say in numbers, by card: `content/materials/answers.json`, worked out again by the contract test. */
export interface Answers {
  readonly tries: { readonly [card: string]: readonly TriesRow[] }
}

/** The tries that a card asks for: those of its table. */
const asked: { readonly [card: string]: readonly number[] } = {
  mars: [1, 10, 100],
}
const usual = [10, 100, 1000]

const outlineOf = (content: ContentFiles, card: string, file: string) =>
  Object.values(content.program(card, file)!.programs).flatMap((program) => learningIn(program) ?? [])[0]!

/** Works out all numbers of answers. Roads are closed as the solution has them, settings are those a child begins with. */
export function answersOf(content: ContentFiles): Answers {
  const cards = content.cards.filter(({ bed }) => bed === 'q-learning').map(({ id }) => id)
  const learned = cards.map((id) => {
    const { settings } = outlineOf(content, id, 'start')
    return [id, { ...outlineOf(content, id, 'solution'), settings }] as const
  })
  return {
    tries: Object.fromEntries(
      learned
        // Where a child chooses the rewards itself no table says what comes of it.
        .filter(([, { pay }]) => !pay?.own)
        .map(([id, outline]) => [id, triesOf(outline, content.mapFile(outline.map)!, asked[id] ?? usual)]),
    ),
  }
}
