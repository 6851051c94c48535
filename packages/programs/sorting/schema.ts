import { LARGEST } from '@botgarten/learning/k-means'
import * as v from 'valibot'
import { mostOfSorting as most, sortingSources, type SortingDocument } from './document.ts'
import { finite } from '../project/schema-program.ts'

const place = v.pipe(finite, v.minValue(-LARGEST), v.maxValue(LARGEST))
const whole = (least: number, largest: number) =>
  v.pipe(v.number(), v.integer(), v.minValue(least), v.maxValue(largest))
const textOf = (letters: number) => v.pipe(v.string(), v.maxLength(letters))
const row = v.pipe(v.array(place), v.minLength(1), v.maxLength(most.columns))
const rowsOf = (rows: number) => v.pipe(v.array(row), v.maxLength(rows))
const short = textOf(most.column)
const axis = whole(-1, most.columns - 1)

const page = v.object({
  source: v.picklist(sortingSources),
  set: short,
  counting: v.pipe(v.array(short), v.maxLength(most.columns)),
  columns: v.pipe(
    v.array(
      v.object({
        ...{ feature: short, part: short, unit: short },
        ...{ low: finite, high: finite, scale: finite },
      }),
    ),
    v.maxLength(most.columns),
  ),
  rows: rowsOf(most.points),
  axes: v.exactOptional(v.tuple([axis, axis])),
  flags: whole(1, most.flags),
  distance: v.picklist(['euclidean', 'manhattan', 'cosine']),
  centres: rowsOf(most.flags),
  names: v.pipe(v.array(textOf(most.name)), v.maxLength(most.flags)),
  run: v.exactOptional(
    v.object({
      start: rowsOf(most.flags),
      phase: v.picklist(['assign', 'move', 'done']),
      ...{ round: whole(0, most.rounds), next: whole(0, most.points) },
    }),
  ),
})

/** Unknown keys are left out. The ids of data sets are checked by the playground, which knows them. */
const sortingSchema: v.GenericSchema<unknown, SortingDocument> = v.object({
  version: v.optional(v.picklist([1, 2]), 1),
  ...page.entries,
  pages: v.exactOptional(v.pipe(v.array(page), v.maxLength(most.pages))),
})

/** Parses foreign data as a sorting playground; null if it is invalid. */
export function sortingIn(data: unknown): SortingDocument | null {
  const read = v.safeParse(sortingSchema, data, { abortEarly: true })
  return read.success ? read.output : null
}
