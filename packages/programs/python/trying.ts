import type { PythonAt } from '@botgarten/blocks'
import { emptyTable, problemOf, statesOf, type Sensor, type TableBrain } from '@botgarten/learning/q-senses'
import { COLOURS, type SensorKind, type SensorPort } from '@botgarten/simulation'
import { tryingIn } from '../trying.ts'
import type { Draft } from './draft.ts'
import type { Writer } from './writer.ts'

const ticksPerSecond = 60

/**
 * What the program has learned by trying with the robot's sensors; a robot that goes on learning may begin with nothing.
 * Undefined: there is no table.
 */
export function tableFor({ draft, usage }: Writer): TableBrain | undefined {
  const outline = tryingIn(usage.program)
  if (!outline) return undefined
  const { tables = {}, learner } = draft.input
  const { id, trial } = outline
  if (Object.hasOwn(tables, id)) return tables[id]
  if (learner !== true || problemOf(trial)) return undefined
  return { ...trial, kind: 'table', ...emptyTable(statesOf(trial), trial.actions.length) }
}

/** One decision by the table, as long as it is held. */
export function callTable(writer: Writer, at: PythonAt): void {
  const table = tableFor(writer)
  if (!table) return void at.missing('trying')
  const { draft } = writer
  const row = `${nameOf(draft, 'TABLE')}[${noticed(draft, at, table)}]`
  doLines(writer, at, table, at.call('best_action', row))
  // The way back of the loop around it is the last tick, as for the block.
  draft.line(at.robot.wait(String(milliseconds(table.hold - 1))))
}

/** How the file calls something of its table. */
export const nameOf = ({ names }: Draft, wanted: string): string => names.of(`trying ${wanted}`, wanted)

/** Ticks that a wait lasts, no shorter (semantics.md, rule 5). */
export const milliseconds = (ticks: number): number => Math.floor((ticks * 1000) / ticksPerSecond)

/** Which row of the table is the present one. */
export function noticed(draft: Draft, at: PythonAt, table: TableBrain): string {
  const notice = nameOf(draft, 'notice')
  if (!draft.helpers.has(notice)) noticeLines(draft, at, table, notice)
  return `${notice}()`
}

/** The robot does an action from now on. */
export function doLines(writer: Writer, at: PythonAt, table: TableBrain, choice: string): void {
  const { draft } = writer
  const [left, right, action] = ['left', 'right', 'action'].map((one) => nameOf(draft, one)) as Three
  const shines = table.actions.some(({ lamp }) => lamp)
  if (shines && choice !== action) draft.line(`${action} = ${choice}`)
  draft.line(`${left}, ${right} = ${nameOf(draft, 'ACTIONS')}[${shines ? action : choice}]`)
  draft.line(at.robot.drive(left, right))
  if (shines) lampLines(writer, at, table, action)
}

type Three = [string, string, string]

/** Actions that do the same to the lamp stand together. */
function lampLines(writer: Writer, at: PythonAt, { actions }: TableBrain, action: string): void {
  for (const colour of ['green', 'orange', 'red', 'off'] as const) {
    const own = actions.flatMap(({ lamp }, k) => (lamp === colour ? [k] : []))
    if (own.length === 0) continue
    writer.draft.line(`if ${own.map((k) => `${action} == ${k}`).join(' or ')}:`)
    writer.inner(() => writer.draft.line(at.robot.lamp(colour === 'off' ? null : colour.toUpperCase(), 'ON')))
  }
}

/** The table at the head of the file, and the function that says which of its rows is the present one. */
function noticeLines(draft: Draft, at: PythonAt, table: TableBrain, name: string): void {
  const constant = (code: string) => draft.constants.push({ code, depth: 0, blocks: [at.block.id] })
  constant(`# ${draft.say(table.moves > 0 ? 'python.tryTable' : 'python.learner.empty')}`)
  constant(`${nameOf(draft, 'TABLE')} = [${rowsOf(table).join(', ')}]`)
  constant(`# ${draft.say('python.tryActions')}`)
  const actions = table.actions.map(({ left, right }) => `(${left}, ${right})`)
  constant(`${nameOf(draft, 'ACTIONS')} = [${actions.join(', ')}]`)
  const buckets = table.sensors.map((sensor, k) => bucketOf(at, sensor, table.edges[k]!))
  const lines = buckets.map((code, k) =>
    k === 0 ? `row = ${code}` : `row = ${table.edges[k]!.length + 1} * row + ${code}`,
  )
  // What a helper is made of stands before it.
  const rows = [`def ${name}():`, ...[...bumpLines(draft, at, table), ...lines, 'return row'].map(inner)]
  draft.helpers.set(name, { rows, blocks: [at.block.id] })
}

const inner = (line: string) => `    ${line}`

const rowsOf = ({ q, actions }: TableBrain): readonly string[] => {
  const count = actions.length
  return Array.from({ length: q.length / count }, (_, row) => {
    const values = q.slice(row * count, (row + 1) * count).map((value) => String(value + 0))
    return `[${values.join(', ')}]`
  })
}

function bucketOf(at: PythonAt, { port, mode }: Sensor, edges: readonly number[]): string {
  if (mode === 'touch') return `(1 if ${at.robot.read('touch', port, 'pressed')?.code ?? 'False'} else 0)`
  if (mode === 'colour') return colourPlace(at, port)
  const kind = mode === 'distance' ? 'ultrasonic' : 'colour'
  const reading = at.robot.read(kind, port, mode)?.code ?? '0'
  return at.call('bucket', reading, `[${edges.join(', ')}]`)
}

function colourPlace(at: PythonAt, port: SensorPort): string {
  const all = Object.values(COLOURS).map((colour) => at.robot.colour(colour))
  const reading = at.robot.read('colour', port, 'colour')?.code ?? 'None'
  return `max(0, ${at.call('first_place', `[${all.join(', ')}]`, reading)})`
}

/** What the sensors of one kind say, in the order of their ports. */
export function readingsOf(draft: Draft, at: PythonAt, kind: SensorKind, what: string): readonly string[] {
  const { sensors } = draft.input.config
  const ports = (Object.keys(sensors) as SensorPort[]).filter((port) => sensors[port]?.kind === kind)
  return ports.sort().flatMap((port) => at.robot.read(kind, port, what)?.code ?? [])
}

/** The lab feels every bump of the body; a robot feels those of its touch sensors. Empty: it has none. */
export const touched = (draft: Draft, at: PythonAt): string =>
  readingsOf(draft, at, 'touch', 'pressed').join(' or ')

function bumpLines(draft: Draft, at: PythonAt, table: TableBrain): readonly string[] {
  if (!table.bump) return []
  const pressed = touched(draft, at)
  if (pressed === '') return [`# ${draft.note(at.block.id, 'python.missing.bump')}`]
  const last = table.q.length / table.actions.length - 1
  return [`if ${pressed}:`, `    return ${last}`]
}
