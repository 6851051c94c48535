import type { MapFile } from '@botgarten/maps'
import { learningIn, type LearningOutline } from '@botgarten/programs'
import type { ContentFiles } from '../files.ts'
import {
  changedOf,
  settingsOf,
  shortestWays,
  triesOf,
  type ChangedRow,
  type SettingName,
  type TriesRow,
} from './tries.ts'

export { practisedAgain, triedAgain } from './again.ts'
export { effortOf } from './efforts.ts'

/** What answers say in numbers, by card: `content/materials/answers.json`, worked out again by the contract test. */
export interface Answers {
  readonly tries: { readonly [card: string]: readonly TriesRow[] }
  /** The settings that a child begins with. */
  readonly settings: { readonly [card: string]: { readonly [name in SettingName]: number } }
  /** Every shortest way. */
  readonly ways: { readonly [card: string]: readonly (readonly number[])[] }
  /** What one other setting does, after few tries. */
  readonly changed: { readonly [card: string]: readonly ChangedRow[] }
}

/** The tries that a card asks for: those of its table. */
const asked: { readonly [card: string]: readonly number[] } = {
  mars: [1, 10, 100],
}
const usual = [10, 100, 1000]
/** Tries after which settings differ most: later every Bo knows the way. */
const few = 10

const outlineOf = (content: ContentFiles, card: string, file: string) =>
  Object.values(content.program(card, file)!.programs).flatMap((program) => learningIn(program) ?? [])[0]!

/** Works out all numbers of answers. Roads are closed as the solution has them, settings are those a child begins with. */
export function answersOf(content: ContentFiles): Answers {
  const cards = content.cards.filter(({ bed }) => bed === 'q-learning').map(({ id }) => id)
  const learned = cards.map((id) => {
    const { settings } = outlineOf(content, id, 'start')
    return [id, { ...outlineOf(content, id, 'solution'), settings }] as const
  })
  // Where a child chooses the rewards itself no table says what comes of it.
  const tabled = learned.filter(([, { pay }]) => !pay?.own)
  const each = <Value>(of: (outline: LearningOutline, map: MapFile, id: string) => Value) =>
    Object.fromEntries(
      tabled.map(([id, outline]) => [id, of(outline, content.mapFile(outline.map)!, id)] as const),
    )
  return {
    tries: each((outline, map, id) => triesOf(outline, map, asked[id] ?? usual)),
    settings: each(settingsOf),
    ways: each(shortestWays),
    changed: each((outline, map) => changedOf(outline, map, few)),
  }
}
