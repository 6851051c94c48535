import {
  headOfRow,
  mostOf,
  place,
  shownBy,
  type Examples,
} from '@botgarten/learning/neural-network/examples/types'
import type { PracticeNote } from '@botgarten/learning/neural-network/brain'
import * as v from 'valibot'
import { longestText } from './limits.ts'
import { finite, idSchema, recordOf } from './schema-program.ts'

const seed = v.pipe(v.number(), v.integer(), v.minValue(0), v.maxValue(4_294_967_295))
const ids = v.pipe(v.array(idSchema), v.maxLength(1000))

const drive = v.object({
  id: idSchema,
  by: v.picklist(shownBy),
  seed,
  note: v.exactOptional(v.pipe(v.string(), v.maxLength(longestText))),
  test: v.exactOptional(v.boolean()),
})

/** No reading, wish or place is as large. */
const value = v.pipe(finite, v.minValue(-1e6), v.maxValue(1e6))
const row = v.pipe(
  v.array(v.nullable(value)),
  v.check((numbers) => !numbers.slice(0, headOfRow).includes(null), 'A row has its head.'),
  v.check((numbers) => numbers[place.on] === 0 || numbers[place.on] === 1, 'A row is on or off.'),
  v.check(
    (numbers) => Number.isInteger(numbers[place.tick]) && numbers[place.tick]! >= 0,
    'A row has a tick.',
  ),
)

/** Rows are as long as there are columns, and belong to drives that are there. */
function fits({ inputs, outputs, drives }: Examples, numbers: readonly (number | null)[]): boolean {
  const [at] = numbers
  const belongs = typeof at === 'number' && Number.isInteger(at) && at >= 0 && at < drives.length
  return belongs && numbers.length === headOfRow + inputs.length + outputs.length
}

const distinct = (names: readonly string[]) => new Set(names).size === names.length

export const examplesSchema: v.GenericSchema<unknown, Examples> = v.pipe(
  v.object({
    version: v.literal(1),
    inputs: ids,
    outputs: ids,
    drives: v.pipe(v.array(drive), v.maxLength(mostOf.drives)),
    rows: v.pipe(v.array(row), v.maxLength(mostOf.rows)),
  }),
  v.check(({ inputs, outputs }) => distinct([...inputs, ...outputs]), 'A column stands there twice.'),
  v.check(({ drives }) => distinct(drives.map(({ id }) => id)), 'A drive stands there twice.'),
  v.rawCheck(({ dataset, addIssue }) => {
    if (!dataset.typed) return
    const examples = dataset.value
    const bad = examples.rows.findIndex((numbers) => !fits(examples, numbers))
    if (bad < 0) return
    const input = examples.rows[bad]!
    addIssue({
      message: 'A row does not fit the columns or the drives.',
      path: [
        { type: 'object', origin: 'value', input: { ...examples }, key: 'rows', value: examples.rows },
        { type: 'array', origin: 'value', input: [...examples.rows], key: bad, value: input },
      ],
    })
  }),
)

const weights = recordOf(recordOf(finite))
const count = v.pipe(v.number(), v.integer(), v.minValue(0), v.maxValue(1_000_000))
const between = (least: number, most: number) => v.pipe(finite, v.minValue(least), v.maxValue(most))

const settings = v.object({
  rate: between(0.0001, 5),
  momentum: between(0, 0.999),
  optimizer: v.picklist(['sgd', 'adam']),
  decay: between(0, 1),
  batch: v.pipe(count, v.minValue(1)),
  rounds: v.pipe(count, v.minValue(1)),
  bias: v.picklist(['on', 'off']),
  range: v.picklist(['free', 'unit']),
  order: v.picklist(['shuffled', 'table']),
  patience: count,
  keepBack: between(0, 1),
  from: v.picklist(['knobs', 'zero']),
  mirror: v.boolean(),
})

/** Of what was practised; the network is learned again from it. */
export const practiceSchema: v.GenericSchema<unknown, PracticeNote> = v.object({
  seed,
  start: weights,
  settings,
  round: count,
  curve: v.pipe(
    v.array(v.object({ round: count, practised: finite, kept: v.nullable(finite) })),
    v.maxLength(1100),
  ),
  marks: v.pipe(v.array(count), v.maxLength(1000)),
  next: v.exactOptional(v.object({ seed, settings })),
})
