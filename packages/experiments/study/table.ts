import { groupBy } from '@botgarten/browsers'
import type { Line } from './log/code-book.ts'
import type { Numbered } from './log/read.ts'

/** What a log says of one child. */
export interface PupilRow {
  readonly pseudonym: string
  readonly group: number
  readonly sessions: number
  /** Of all its sessions together, in seconds, pauses included. */
  readonly seconds: number
  /** Labs that were opened: different cards, and the free lab. */
  readonly places: number
  /** Seconds from the first session's beginning to the first Start; null: never. */
  readonly firstRun: number | null
  /** How often Start was pressed. */
  readonly tries: number
  /** How often a knob was moved: one pull is one, until it rests for a second. */
  readonly knobs: number
  readonly edits: number
  readonly steps: number
  readonly hints: number
  /** Different checks that were green at some time, each card's its own. */
  readonly checks: number
}

/** A knob that rests for so long, in milliseconds, is moved anew. */
const pull = 1000

/** One row a pseudonym, in order of pseudonyms. */
export function tableOf(lines: readonly Numbered[]): readonly PupilRow[] {
  const byChild = groupBy(
    lines.map(({ says }) => says),
    ({ pseudonym }) => pseudonym,
  )
  return [...byChild].sort(([a], [b]) => (a < b ? -1 : 1)).map(([, own]) => rowOf(own))
}

function rowOf(own: readonly Line[]): PupilRow {
  const sessions = [...groupBy(own, ({ session }) => session).values()]
  const count = (event: Line['event']) => own.filter((line) => line.event === event).length
  const places = own.filter((line) => line.event === 'open').map(({ place }) => place)
  const run = sessions[0]?.find(({ event }) => event === 'run')
  return {
    pseudonym: own[0]!.pseudonym,
    group: own.find((line) => line.event === 'session')!.group,
    sessions: sessions.length,
    seconds: sessions.reduce((sum, lines) => sum + lines.at(-1)!.t, 0) / 1000,
    places: new Set(places).size,
    firstRun: run ? run.t / 1000 : null,
    tries: count('run'),
    knobs: sessions.reduce((sum, lines) => sum + pullsIn(lines), 0),
    ...{ edits: count('edit'), steps: count('step'), hints: count('hint') },
    checks: new Set(sessions.flatMap(greenIn)).size,
  }
}

function pullsIn(lines: readonly Line[]): number {
  const last = new Map<string, number>()
  let pulls = 0
  for (const line of lines) {
    if (line.event !== 'knob') continue
    const knob = [line.brain, line.from, line.to, line.set].join('\n')
    const before = last.get(knob)
    if (before === undefined || line.t - before >= pull) pulls += 1
    last.set(knob, line.t)
  }
  return pulls
}

/** Checks that turned green, with the card they belong to. */
function greenIn(lines: readonly Line[]): readonly string[] {
  let place = ''
  const green: string[] = []
  for (const line of lines) {
    if (line.event === 'open') place = line.place
    if (line.event === 'check' && line.passed) green.push(`${place} ${line.check}`)
  }
  return green
}

const columns = [
  ...(['pseudonym', 'group', 'sessions', 'seconds', 'places', 'firstRun', 'tries', 'knobs'] as const),
  ...(['edits', 'steps', 'hints', 'checks'] as const),
] satisfies readonly (keyof PupilRow)[]

/** The table as rows of a CSV file, names first. */
export const rowsOfTable = (table: readonly PupilRow[]): readonly (readonly (string | number)[])[] => [
  columns,
  ...table.map((row) => columns.map((name) => row[name] ?? '')),
]
