import * as v from 'valibot'
import { setOf, sets } from './sets.ts'
import {
  handTable,
  MOST_FLAGS,
  MOST_POINTS,
  placed,
  thingTable,
  withTable,
  type Table,
  type Work,
} from './work.ts'

/** What a device keeps of the playground. */
export type Kept = v.InferOutput<typeof kept>

const number = v.pipe(v.number(), v.finite())
const row = v.pipe(v.array(number), v.minLength(1))
const kept = v.object({
  source: v.picklist(['things', 'points', 'readings']),
  set: v.string(),
  counting: v.array(v.string()),
  columns: v.array(
    v.object({
      ...{ feature: v.string(), part: v.string(), unit: v.string() },
      ...{ low: number, high: number, scale: number },
    }),
  ),
  rows: v.pipe(v.array(row), v.maxLength(MOST_POINTS)),
  flags: v.pipe(v.number(), v.integer(), v.minValue(1), v.maxValue(MOST_FLAGS)),
  distance: v.picklist(['euclidean', 'manhattan', 'cosine']),
  centres: v.array(row),
  names: v.pipe(v.array(v.string()), v.maxLength(MOST_FLAGS)),
})

export function written(work: Work, names: readonly string[]): Kept {
  const { source, set, counting, table, flags, distance, state } = work
  const { columns, rows } = source === 'things' ? { columns: [], rows: [] } : table
  return {
    ...{ source, set, counting: [...counting], flags, distance, names: [...names] },
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
  ...{ flags: 3, distance: 'euclidean', state: null, throws: 1 },
}

const first = () => ({
  work: withTable(nothing, thingTable(setOf('vessels'), nothing.counting)),
  names: [] as readonly string[],
})

/** The playground as it was left; what does not fit any more is the first one. */
export function read(json: unknown): { readonly work: Work; readonly names: readonly string[] } {
  const parsed = v.safeParse(kept, json)
  if (!parsed.success) return first()
  const { names, centres, source, set, counting, flags, distance } = parsed.output
  const table = tableIn(parsed.output)
  if (table === null) return first()
  const begun = { ...nothing, source, set, counting, flags, distance }
  const work = withTable(begun, table)
  const fits = centres.length === work.flags && centres.every((one) => one.length === table.columns.length)
  return { work: work.state && fits ? placed(work, centres) : work, names }
}

function tableIn({ source, set, counting, columns, rows }: Kept): Table | null {
  if (source === 'things') return sets.some(({ id }) => id === set) ? thingTable(setOf(set), counting) : null
  return rows.every((one) => one.length === columns.length) ? { columns, rows } : null
}
