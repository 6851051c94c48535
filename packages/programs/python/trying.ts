import type { PythonAt } from '@botgarten/blocks'
import type { Sensor, TableBrain } from '@botgarten/learning/q-senses'
import { COLOURS, type SensorPort } from '@botgarten/simulation'
import { tryingIn } from '../trying.ts'
import type { Draft } from './draft.ts'
import type { Writer } from './writer.ts'

const ticksPerSecond = 60

/** What the program has learned by trying with the robot's sensors; undefined: nothing yet. */
function tableFor({ draft, usage }: Writer): TableBrain | undefined {
  const id = tryingIn(usage.program)?.id
  const { tables = {} } = draft.input
  return id !== undefined && Object.hasOwn(tables, id) ? tables[id] : undefined
}

/** One decision by the table, as long as it is held. */
export function callTable(writer: Writer, at: PythonAt): void {
  const { draft } = writer
  const table = tableFor(writer)
  if (!table) return void at.missing('trying')
  const { names } = draft
  const notice = names.of('trying notice', 'notice')
  if (!draft.helpers.has(notice)) noticeLines(draft, at, table, notice)
  const [left, right] = [names.of('trying left', 'left'), names.of('trying right', 'right')]
  const [values, actions] = [constantOf(draft, 'TABLE'), constantOf(draft, 'ACTIONS')]
  const best = at.call('best_action', `${values}[${notice}()]`)
  const shines = table.actions.some(({ lamp }) => lamp)
  const action = names.of('trying action', 'action')
  if (shines) draft.line(`${action} = ${best}`)
  draft.line(`${left}, ${right} = ${actions}[${shines ? action : best}]`)
  draft.line(at.robot.drive(left, right))
  if (shines) lampLines(writer, at, table, action)
  draft.line(at.robot.wait(String(heldFor(table))))
}

/** Actions that do the same to the lamp stand together. */
function lampLines(writer: Writer, at: PythonAt, { actions }: TableBrain, action: string): void {
  for (const colour of ['green', 'orange', 'red', 'off'] as const) {
    const own = actions.flatMap(({ lamp }, k) => (lamp === colour ? [k] : []))
    if (own.length === 0) continue
    writer.draft.line(`if ${own.map((k) => `${action} == ${k}`).join(' or ')}:`)
    writer.inner(() => writer.draft.line(at.robot.lamp(colour === 'off' ? null : colour.toUpperCase(), 'ON')))
  }
}

const constantOf = ({ names }: Draft, wanted: 'TABLE' | 'ACTIONS') => names.of(`trying ${wanted}`, wanted)

/** Milliseconds. The way back of the loop around it is the last tick, as for the block. */
const heldFor = ({ hold }: TableBrain): number => Math.floor(((hold - 1) * 1000) / ticksPerSecond)

/** The table at the head of the file, and the function that says which of its rows is the present one. */
function noticeLines(draft: Draft, at: PythonAt, table: TableBrain, name: string): void {
  const constant = (code: string) => draft.constants.push({ code, depth: 0, blocks: [at.block.id] })
  constant(`# ${draft.say('python.tryTable')}`)
  constant(`${constantOf(draft, 'TABLE')} = [${rowsOf(table).join(', ')}]`)
  constant(`# ${draft.say('python.tryActions')}`)
  const actions = table.actions.map(({ left, right }) => `(${left}, ${right})`)
  constant(`${constantOf(draft, 'ACTIONS')} = [${actions.join(', ')}]`)
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

/** The lab feels every bump of the body; a robot feels those of its touch sensors. */
function bumpLines(draft: Draft, at: PythonAt, table: TableBrain): readonly string[] {
  if (!table.bump) return []
  const { sensors } = draft.input.config
  const touch = (Object.keys(sensors) as SensorPort[]).filter((port) => sensors[port]?.kind === 'touch')
  const pressed = touch.flatMap((port) => at.robot.read('touch', port, 'pressed')?.code ?? [])
  if (pressed.length === 0) return [`# ${draft.note(at.block.id, 'python.missing.bump')}`]
  const last = table.q.length / table.actions.length - 1
  return [`if ${pressed.join(' or ')}:`, `    return ${last}`]
}
