import {
  bestOf,
  plusPlusStart,
  pointsOf,
  randomStart,
  startAt,
  type Distance,
  type KState,
  type Points,
} from '@botgarten/learning/k-means'
import { mostOfSorting, type SortingColumn, type SortingSource } from '@botgarten/programs/sorting'
import { columnsOf, onPlane, rawOf, type ThingSet } from '@botgarten/content/things'
import { stream } from '@botgarten/numbers'
import { setOf } from '#figures/things/sets.ts'
import { traps } from './traps.ts'

export type Source = SortingSource
export type Start = 'random' | '++' | 'best'

/** Rows of numbers with their columns, on the plane's scale of 0 to 10. */
export interface Table {
  readonly columns: readonly SortingColumn[]
  readonly rows: readonly (readonly number[])[]
}

/** The whole playground as plain data: every change makes a new one, and the line of them is the way back. */
export interface Work {
  readonly source: Source
  /** Id of the data set; '' for points drawn by hand, `OWN_TABLE` for those of a file. */
  readonly set: string
  /** Features of the things that count. */
  readonly counting: readonly string[]
  readonly table: Table
  /** Columns that lie along the two axes; −1: none does. */
  readonly axes: readonly [x: number, y: number]
  readonly flags: number
  /** By group, as children call them. */
  readonly names: readonly string[]
  readonly distance: Distance
  /** Null where there is nothing to sort yet. */
  readonly state: KState | null
  /** Where the flags of this state were placed. */
  readonly start: KState['centres']
  /** Grows with every throw of the flags, so that each is another one. */
  readonly throws: number
}

/** Are the flags where they were placed? */
export const isFresh = ({ state }: Work): boolean =>
  state !== null && state.phase === 'assign' && state.round === 0 && state.next === 0

/** As many flags as a page begins with. */
const FIRST_FLAGS = 3
export const MOST_FLAGS = mostOfSorting.flags
/** That Bo collects on the playground's floor. */
export const MOST_READINGS = 300
export const MOST_POINTS = mostOfSorting.points
export const MOST_COLUMNS = mostOfSorting.columns
/** The data set whose points are from a file. */
export const OWN_TABLE = 'table'

/** Are both about one data set? */
export const isSame = (a: Pick<Work, 'source' | 'set'>, b: Pick<Work, 'source' | 'set'>): boolean =>
  a.source === b.source && a.set === b.set

const inUnit = { part: '', low: 0, high: 10, scale: 10 }

export const thingTable = (set: ThingSet, counting: readonly string[]): Table => {
  const columns = columnsOf(set, counting)
  const rows = set.things.map((thing) => columns.map((one) => onPlane(rawOf(set, thing, one), one)))
  return { columns, rows }
}

/** Points by hand: right and up on the plane. */
export const handTable = (rows: Table['rows']): Table => ({
  columns: ['right', 'up'].map((feature) => ({ ...inUnit, feature, unit: '' })),
  rows,
})

/** What a colour sensor has read: red, green and blue, 0 to 255. */
export const readingTable = (rows: Table['rows']): Table => ({
  columns: ['red', 'green', 'blue'].map((part) => ({
    ...inUnit,
    feature: 'colour',
    part,
    unit: '',
    high: 255,
  })),
  rows: rows.map((row) => row.map((value) => (value / 255) * 10)),
})

/** A file's columns, each as wide as the plane. */
export function fileTable(names: readonly string[], rows: Table['rows']): Table {
  const columns = names.map((feature, at) => {
    const values = rows.map((row) => row[at]!)
    const [low, high] = [values.reduce((a, b) => Math.min(a, b)), values.reduce((a, b) => Math.max(a, b))]
    return { ...inUnit, feature: feature.slice(0, mostOfSorting.column), unit: '', low, high }
  })
  return { columns, rows: rows.map((row) => row.map((value, at) => onPlane(value, columns[at]!))) }
}

const asPoints = new WeakMap<Table, Points>()

/** A table's rows as what k-means reads; the same for the same table. */
export function pointsIn(table: Table): Points {
  const points = asPoints.get(table) ?? pointsOf(table.rows)
  asPoints.set(table, points)
  return points
}

const sortable = ({ columns, rows }: Table) => columns.length > 0 && rows.length > 0

/** As many flags as are wanted, or as there can be: no more than points. An empty table waits for points. */
export const flagsFor = (wanted: number, { rows }: Table): number =>
  Math.max(1, Math.min(wanted, MOST_FLAGS, rows.length || MOST_FLAGS))

/** Other rows or columns: flags are thrown again. */
export function withTable(work: Work, table: Table): Work {
  const { length } = table.columns
  // Of red, green and blue, red and blue part colours best.
  const axes = [length > 0 ? 0 : -1, work.source === 'readings' ? 2 : length > 1 ? 1 : -1] as const
  return thrown({ ...work, table, axes, flags: flagsFor(work.flags, table) })
}

/** Flags that too few points have kept away come back with more. */
const wantedFlags = ({ flags, table }: Work): number =>
  table.rows.length <= flags ? Math.max(flags, FIRST_FLAGS) : flags

/** More readings, and no flags while they come. */
export function withReadings(work: Work, readings: Table['rows']): Work {
  const { rows: before, columns } = work.table
  const rows = [...before, ...readingTable(readings).rows].slice(0, MOST_READINGS)
  return { ...work, flags: wantedFlags(work), table: { columns, rows }, state: null }
}

/** All flags at new places, nothing sorted yet. */
export function thrown(work: Work, start: Start = 'random'): Work {
  if (!sortable(work.table)) return { ...work, state: null }
  const { table, flags, distance, throws } = work
  const points = pointsIn(table)
  const chance = stream(throws, 'learn/sorting/flags')
  if (start === 'best') {
    const { centres } = bestOf(points, flags, { starts: 10, init: '++', distance, stream: chance })
    return { ...placed(work, centres), throws: throws + 1 }
  }
  const centres =
    start === '++' ? plusPlusStart(points, flags, distance, chance) : randomStart(points, flags, chance)
  return { ...placed(work, centres), throws: throws + 1 }
}

/** Flags where a hand has put them: sorting begins again from there. */
export function placed(work: Work, centres: KState['centres']): Work {
  return { ...work, start: centres, state: startAt(pointsIn(work.table), centres, work.distance) }
}

/** One flag more, or fewer; the others stay. */
export function withFlags(work: Work, wanted: number): Work {
  const flags = flagsFor(wanted, work.table)
  if (!work.state) return { ...work, flags }
  const kept = work.state.centres.slice(0, flags)
  const more = randomStart(
    pointsIn(work.table),
    flags - kept.length || 1,
    stream(work.throws, 'learn/sorting/flags'),
  ).slice(0, flags - kept.length)
  return { ...placed({ ...work, flags }, [...kept, ...more]), throws: work.throws + 1 }
}

// ---- other things to sort; names of groups that were go ----

export function workOfSet(work: Work, id: string): Work {
  const set = setOf(id)
  const counting = set.features.slice(0, 2).map((feature) => feature.id)
  return begun({ ...work, source: 'things', set: id, counting }, thingTable(set, counting))
}

/** The points of a data set of the product, always the same object; null for an unknown name. */
export function trapTable(name: string): Table | null {
  if (!Object.hasOwn(traps, name)) return null
  const table = trapTables.get(name) ?? handTable(traps[name]!.rows())
  trapTables.set(name, table)
  return table
}
const trapTables = new Map<string, Table>()

export const workOfTrap = (work: Work, name: string): Work =>
  begun({ ...work, source: 'points', set: name, counting: [] }, trapTable(name)!, traps[name]!.flags)

/** Columns and rows of a file. */
export const workOfFile = (work: Work, names: readonly string[], rows: Table['rows']): Work =>
  begun({ ...work, source: 'points', set: OWN_TABLE, counting: [] }, fileTable(names, rows))

export const withoutPoints = (work: Work): Work =>
  begun({ ...work, source: 'points', set: '', counting: [] }, handTable([]), work.flags)

export const withoutReadings = (work: Work): Work =>
  begun({ ...work, source: 'readings', set: '', counting: [] }, readingTable([]))

const begun = (work: Work, table: Table, flags = FIRST_FLAGS): Work =>
  withTable({ ...work, flags, names: [] }, table)

// ---- one thing of it another ----

export function withFeature(work: Work, feature: string, on: boolean): Work {
  const { set, counting } = work
  const next = on ? [...counting, feature] : counting.filter((one) => one !== feature)
  return withTable({ ...work, counting: next }, thingTable(setOf(set), next))
}

/** The flags stay where they are while points come and go, as long as there are enough. */
export function withRows(work: Work, rows: Table['rows']): Work {
  const table = { ...work.table, rows }
  const flags = flagsFor(wantedFlags(work), table)
  const stay = work.state !== null && flags === work.flags
  return stay ? placed({ ...work, table }, work.state.centres) : withTable({ ...work, flags }, table)
}

/** A column that lies along the other axis changes places with the one that lay here. */
export function withAxis(work: Work, axis: 0 | 1, column: number): Work {
  const other = work.axes[1 - axis]!
  const swapped = column === other ? work.axes[axis] : other
  return { ...work, axes: axis === 0 ? [column, swapped] : [swapped, column] }
}

export function withDistance(work: Work, distance: Distance): Work {
  const next = { ...work, distance }
  return work.state ? placed(next, work.state.centres) : next
}

export function withName(work: Work, group: number, name: string): Work {
  const length = Math.max(work.names.length, group + 1)
  const names = Array.from({ length }, (_, at) => work.names[at] ?? '')
  return { ...work, names: names.with(group, name) }
}
