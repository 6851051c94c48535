import type { Block, Value } from '@botgarten/blocks'
import type { Variable } from '@botgarten/lab'
import type { Program } from '@botgarten/programs'
import { decimalMark, formatNumber } from '#drawing/numbers.ts'

/** Words that a value may need. */
export interface ValueWords {
  readonly locale: string
  readonly yes: string
  readonly no: string
}

export const noValues: ReadonlyMap<string, string> = new Map()

const most = 8

/** A value as a child reads it: the language's own comma, lists with their first entries. */
export function valueText(value: Value, words: ValueWords): string {
  if (typeof value === 'number') return formatNumber(value, words.locale, 4)
  if (typeof value === 'boolean') return value ? words.yes : words.no
  if (typeof value === 'string') return /^#[0-9A-F]{6}$/i.test(value) ? value : `“${value}”`
  if (value === null || !Array.isArray(value)) return '–'
  const entries = (value as readonly Value[]).slice(0, most).map((entry) => valueText(entry, words))
  return `[${entries.join(decimalMark(words.locale) === ',' ? '; ' : ', ')}${value.length > most ? ' …' : ''}]`
}

/** What stands at the blocks that name a variable: its value where they are, by the blocks' ids. */
export function valuesAtBlocks(
  program: Program,
  variables: readonly Variable[],
  words: ValueWords,
): ReadonlyMap<string, string> {
  const values = new Map<string, string>()
  for (const { blocks } of program.stacks) {
    const [top] = blocks
    const home = top && /^robProcedures_def/.test(top.type) ? top.id : null
    const here = new Map(
      variables.filter(({ of }) => of === null || of === home).map((one) => [one.name, one]),
    )
    for (const block of blocks) note(block, here, words, values)
  }
  return values
}

function note(
  block: Block,
  here: ReadonlyMap<string, Variable>,
  words: ValueWords,
  values: Map<string, string>,
): void {
  const variable = here.get(block.fields?.['VAR'] ?? '')
  if (variable) values.set(block.id, valueText(variable.value, words))
  for (const child of Object.values(block.values ?? {})) note(child, here, words, values)
  for (const row of Object.values(block.statements ?? {}))
    for (const child of row) note(child, here, words, values)
}
