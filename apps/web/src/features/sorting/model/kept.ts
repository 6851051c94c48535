import {
  sortingIn,
  type SortingDocument,
  type SortingPage,
  type SortingRun,
} from '@botgarten/programs/sorting'
import { stepOne, stepPhase, type KState } from '@botgarten/learning/k-means'
import { setOf, sets } from '#figures/things/sets.ts'
import { traps } from './traps.ts'
import {
  handTable,
  isSame,
  OWN_TABLE,
  placed,
  pointsIn,
  readingTable,
  thingTable,
  trapTable,
  withTable,
  type Table,
  type Work,
} from './work.ts'

/** @param others other data sets, the last displayed one at the end */
export function written(work: Work, others: readonly Work[] = []): SortingDocument {
  const left = others.filter((one) => !isSame(one, work))
  const sources = new Set([work, ...left].map(({ source }) => source))
  const version = sources.size === left.length + 1 ? 1 : 2
  const pages = left.map((one) => pageOf(one, version))
  return { version, ...pageOf(work, version), ...(pages.length > 0 && { pages }) }
}

const noRows = { columns: [], rows: [] }

/** Version 1 has the rows of data sets of the product, too. */
function pageOf(work: Work, version: 1 | 2): SortingPage {
  const { source, set, counting, table, axes, flags, distance, state, names } = work
  const isKnown = source === 'things' || (version === 2 && source === 'points' && table === trapTable(set))
  const { columns, rows } = isKnown ? noRows : table
  return {
    ...{ source, set, counting: [...counting], flags, distance, names: [...names] },
    axes: [axes[0], axes[1]],
    columns: [...columns],
    rows: rows.map((one) => [...one]),
    centres: state?.centres.map((one) => [...one]) ?? [],
    ...(state && isBegun(state) && { run: runOf(work, state) }),
  }
}

const isBegun = ({ phase, round, next }: KState) => phase !== 'assign' || round > 0 || next > 0

const runOf = ({ start }: Work, { phase, round, next }: KState): SortingRun => ({
  start: start.map((one) => [...one]),
  ...{ phase, round, next },
})

const nothing: Work = {
  ...{
    source: 'things',
    set: 'vessels',
    counting: ['width', 'height'],
    table: handTable([]),
    axes: [-1, -1],
  },
  ...{ flags: 3, names: [], distance: 'euclidean', state: null, start: [], throws: 1 },
}

export const firstWork = (): Work => withTable(nothing, thingTable(setOf('vessels'), nothing.counting))

/** Readings of a colour sensor, red, green and blue from 0 to 255, ready to be sorted. */
export const workOfReadings = (rows: readonly (readonly number[])[]): Work =>
  withTable({ ...nothing, source: 'readings', set: '', counting: [] }, readingTable(rows))

/** The same in a project that has a playground already: its other data sets stay. */
export function writtenReadings(rows: readonly (readonly number[])[], before: unknown): SortingDocument {
  const left = read(before)
  return written(workOfReadings(rows), [...othersIn(before), ...(left ? [left] : [])])
}

/** The playground as it was left; null for what is none, or what a newer Botgarten has left. Nothing of it is trusted. */
export function read(json: unknown): Work | null {
  const document = sortingIn(json)
  return document && workIn(document)
}

/** What was left of its other data sets. */
export const othersIn = (json: unknown): readonly Work[] =>
  (sortingIn(json)?.pages ?? []).flatMap((one) => workIn(one) ?? [])

function workIn(left: SortingPage): Work | null {
  const { names, centres, axes, source, counting, flags, distance, run } = left
  const table = tableIn(left)
  if (table === null) return null
  const set = source === 'points' && left.set === '' && !isDrawn(table) ? OWN_TABLE : left.set
  const begun = withTable({ ...nothing, source, set, counting, flags, distance }, table)
  const shown = axes?.every((one) => one < table.columns.length) ? axes : begun.axes
  const work = { ...begun, names, axes: shown }
  const fits = (all: KState['centres']) =>
    all.length === begun.flags && all.every((one) => one.length === table.columns.length)
  if (!work.state || !fits(centres)) return work
  return run && fits(run.start) ? repeated(placed(work, run.start), run) : placed(work, centres)
}

/** Drawn by hand, and not from a file: files of version 1 called both alike. */
const isDrawn = ({ columns }: Table) => columns.every(({ feature }) => ['right', 'up'].includes(feature))

/** The same steps from the same flags come to the same groups. */
function repeated(work: Work, { phase, round, next }: SortingRun): Work {
  const points = pointsIn(work.table)
  let state = work.state!
  const isBefore = () => state.round < round || (state.round === round && state.phase !== phase)
  while (state.phase !== 'done' && isBefore()) state = stepPhase(points, state)
  for (let at = 0; at < next && state.phase === phase; at++) state = stepOne(points, state).state
  return { ...work, state }
}

function tableIn({ source, set, counting, columns, rows }: SortingPage): Table | null {
  if (source === 'things') return sets.some(({ id }) => id === set) ? thingTable(setOf(set), counting) : null
  const isTrap = source === 'points' && columns.length === 0 && Object.hasOwn(traps, set)
  if (isTrap) return trapTable(set)
  return rows.every((one) => one.length === columns.length) ? { columns, rows } : null
}
