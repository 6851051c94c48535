import { LARGEST } from '@botgarten/learning/k-means'
import * as v from 'valibot'
import { setOf, sets } from '#figures/things/sets.ts'
import {
  handTable,
  LONGEST_COLUMN,
  MOST_COLUMNS,
  MOST_FLAGS,
  MOST_POINTS,
  placed,
  readingTable,
  thingTable,
  withTable,
  type Table,
  type Work,
} from './work.ts'

/** The playground as a device or a project keeps it. */
export type Kept = v.InferOutput<typeof kept>

const newest = 1
export const LONGEST_NAME = 24
const number = v.pipe(v.number(), v.finite())
const place = v.pipe(number, v.minValue(-LARGEST), v.maxValue(LARGEST))
const row = v.pipe(v.array(place), v.minLength(1), v.maxLength(MOST_COLUMNS))
const short = v.pipe(v.string(), v.maxLength(LONGEST_COLUMN))
const axis = v.pipe(v.number(), v.integer(), v.minValue(-1), v.maxValue(MOST_COLUMNS - 1))
const page = v.object({
  source: v.picklist(['things', 'points', 'readings']),
  set: short,
  counting: v.pipe(v.array(short), v.maxLength(MOST_COLUMNS)),
  columns: v.pipe(
    v.array(
      v.object({
        ...{ feature: short, part: short, unit: short },
        ...{ low: number, high: number, scale: number },
      }),
    ),
    v.maxLength(MOST_COLUMNS),
  ),
  rows: v.pipe(v.array(row), v.maxLength(MOST_POINTS)),
  axes: v.optional(v.tuple([axis, axis])),
  flags: v.pipe(v.number(), v.integer(), v.minValue(1), v.maxValue(MOST_FLAGS)),
  distance: v.picklist(['euclidean', 'manhattan', 'cosine']),
  centres: v.pipe(v.array(row), v.maxLength(MOST_FLAGS)),
  names: v.pipe(v.array(v.pipe(v.string(), v.maxLength(LONGEST_NAME))), v.maxLength(MOST_FLAGS)),
})
type Page = v.InferOutput<typeof page>
const kept = v.object({
  version: v.optional(v.literal(newest), newest),
  ...page.entries,
  /** What lies on the other pages. */
  pages: v.optional(v.pipe(v.array(page), v.maxLength(2))),
})

/** @param others what was left on other pages */
export function written(work: Work, others: readonly Work[] = []): Kept {
  const pages = others.filter(({ source }) => source !== work.source).map(pageOf)
  return { version: newest, ...pageOf(work), ...(pages.length > 0 && { pages }) }
}

function pageOf(work: Work): Page {
  const { source, set, counting, table, axes, flags, distance, state, names } = work
  const { columns, rows } = source === 'things' ? { columns: [], rows: [] } : table
  return {
    ...{ source, set, counting: [...counting], flags, distance, names: [...names] },
    axes: [axes[0], axes[1]],
    columns: [...columns],
    rows: rows.map((one) => [...one]),
    centres: state?.centres.map((one) => [...one]) ?? [],
  }
}

const nothing: Work = {
  ...{
    source: 'things',
    set: 'vessels',
    counting: ['width', 'height'],
    table: handTable([]),
    axes: [-1, -1],
  },
  ...{ flags: 3, names: [], distance: 'euclidean', state: null, throws: 1 },
}

export const firstWork = (): Work => withTable(nothing, thingTable(setOf('vessels'), nothing.counting))

/** Readings of a colour sensor, red, green and blue from 0 to 255, ready to be sorted. */
export const workOfReadings = (rows: readonly (readonly number[])[]): Work =>
  withTable({ ...nothing, source: 'readings', set: '', counting: [] }, readingTable(rows))

/** The same on the page of a project that has a playground already: its other pages stay. */
export function writtenReadings(rows: readonly (readonly number[])[], before: unknown): Kept {
  const left = read(before)
  return written(workOfReadings(rows), [...(left ? [left] : []), ...othersIn(before)])
}

/** The playground as it was left; null for what is none, or what a newer Botgarten has left. Nothing of it is trusted. */
export function read(json: unknown): Work | null {
  const parsed = v.safeParse(kept, json, { abortEarly: true })
  return parsed.success ? workIn(parsed.output) : null
}

/** What was left on its other pages. */
export function othersIn(json: unknown): readonly Work[] {
  const parsed = v.safeParse(kept, json, { abortEarly: true })
  return parsed.success ? (parsed.output.pages ?? []).flatMap((one) => workIn(one) ?? []) : []
}

function workIn(left: Page): Work | null {
  const { names, centres, axes, source, set, counting, flags, distance } = left
  const table = tableIn(left)
  if (table === null) return null
  const begun = withTable({ ...nothing, source, set, counting, flags, distance }, table)
  const fits = centres.length === begun.flags && centres.every((one) => one.length === table.columns.length)
  const shown = axes?.every((one) => one < table.columns.length) ? axes : begun.axes
  const work = { ...begun, names, axes: shown }
  return work.state && fits ? placed(work, centres) : work
}

function tableIn({ source, set, counting, columns, rows }: Page): Table | null {
  if (source === 'things') return sets.some(({ id }) => id === set) ? thingTable(setOf(set), counting) : null
  return rows.every((one) => one.length === columns.length) ? { columns, rows } : null
}
