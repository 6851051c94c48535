import { isInSample, PARTS } from '../scripts/gate/sample.mjs'
import { tablet, type HandName } from './hand.ts'
import { languages, type Language } from './words.ts'

/** The language and the input device of a walk. */
export interface Variant {
  readonly language: Language
  readonly hand: HandName
}

/** All variants. */
export const variants: readonly Variant[] = languages.flatMap((language) =>
  (['mouse', 'finger'] as const).map((hand) => ({ language, hand })),
)

/**
 * The variants in which something of this name is walked: all of them; a single one where there is a sample, 0 to 3, such as the
 * one that `npm run test:full` draws by the commit's id. The four samples together contain all variants of each name.
 * @param {string} name such as a card's id
 */
export function variantsOf(name: string, sample = process.env['BOTGARTEN_SAMPLE']): readonly Variant[] {
  if (sample === undefined) return variants
  return variants.filter((_, index) => isInSample(name, (index + Number(sample)) % PARTS))
}

/**
 * The items of a list that a sample contains: every fourth one; all of them without a sample. The four samples together
 * contain all.
 */
export const sampled = <Item>(
  all: readonly Item[],
  sample = process.env['BOTGARTEN_SAMPLE'],
): readonly Item[] =>
  sample === undefined ? all : all.filter((_, index) => index % PARTS === Number(sample))

/** Settings of Playwright for a variant: a finger has a tablet. */
export const settingsOf = ({ language, hand }: Variant) => ({
  ...{ language, hand },
  ...(hand === 'finger' && tablet),
})
