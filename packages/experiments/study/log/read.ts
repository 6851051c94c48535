import * as v from 'valibot'
import { codeBook, everyLine, format, type Line } from './code-book.ts'
import { kinds, type Kind } from './kinds.ts'

/** Limits of a file. A lesson of a child is about a megabyte. */
export const most = {
  /** Letters of a line: a project has as many. */
  line: 5_000_000,
  lines: 500_000,
  /** Simulated time of one session: eight hours, in ticks. */
  ticks: 8 * 60 * 60 * 60,
}

/** Why a line is refused; whoever shows it has a sentence for each. */
export type Reason =
  | 'tooLong'
  | 'tooMany'
  | 'notJson'
  | 'noEvent'
  | 'field'
  | 'format'
  | 'noSession'
  | 'otherChild'
  | 'timeBack'
  | 'tooMuchTime'
  | 'cannotPlay'

/** A line that is refused. `line` counts from 1. */
export interface Fault {
  readonly line: number
  readonly reason: Reason
  readonly facts: { readonly [name: string]: string | number }
}

/** A line of a file that could be read. */
export interface Numbered {
  readonly line: number
  readonly says: Line
}

export interface ReadLog {
  readonly lines: readonly Numbered[]
  readonly faults: readonly Fault[]
}

/** What is known of the session that a line belongs to. */
interface Session {
  readonly pseudonym: string
  t: number
  ticks: number
}

class LineError extends Error {
  readonly reason: Reason
  readonly facts: Fault['facts']
  constructor(reason: Reason, facts: Fault['facts'] = {}) {
    super(reason)
    this.reason = reason
    this.facts = facts
  }
}

/** Reads a log. Nothing of it is trusted: a line that breaks a rule is refused by itself, with its number. Never throws. */
export function readLog(text: string): ReadLog {
  const lines: Numbered[] = []
  const faults: Fault[] = []
  const sessions = new Map<string, Session>()
  let line = 0
  for (const raw of linesIn(text)) {
    line += 1
    if (raw === '') continue
    if (line > most.lines) {
      faults.push({ line, reason: 'tooMany', facts: { most: most.lines } })
      break
    }
    try {
      lines.push({ line, says: fitting(lineIn(raw), sessions) })
    } catch (error) {
      if (!(error instanceof LineError)) throw error
      faults.push({ line, reason: error.reason, facts: error.facts })
    }
  }
  return { lines, faults }
}

function* linesIn(text: string): Generator<string> {
  let from = text.startsWith('\uFEFF') ? 1 : 0
  while (from < text.length) {
    const found = text.indexOf('\n', from)
    const to = found < 0 ? text.length : found
    yield text.slice(from, to).trim()
    from = to + 1
  }
}

function lineIn(raw: string): Line {
  if (raw.length > most.line) throw new LineError('tooLong', { most: most.line })
  const data = dataIn(raw)
  const name = data['event']
  if (typeof name !== 'string' || !Object.hasOwn(codeBook, name))
    throw new LineError('noEvent', { event: typeof name === 'string' ? name.slice(0, 40) : '' })
  if (name === 'session' && data['format'] !== format) throw new LineError('format', { format })
  const result = v.safeParse(schemas[name]!, data, { abortEarly: true })
  if (result.success) return result.output as Line
  const [issue] = result.issues
  throw new LineError('field', { event: name, field: fieldOf(issue.path?.[0]?.key) })
}

const fieldOf = (key: unknown) => (typeof key === 'string' ? key.slice(0, 40) : '')

function dataIn(raw: string): { readonly [name: string]: unknown } {
  try {
    const data: unknown = JSON.parse(raw)
    if (typeof data === 'object' && data !== null && !Array.isArray(data)) return data as never
  } catch {
    // Said below.
  }
  throw new LineError('notJson')
}

const schemaOf = (notes: { readonly [name: string]: readonly [Kind, string] }) =>
  Object.fromEntries(Object.entries(notes).map(([name, [kind]]) => [name, kinds[kind]]))

const schemas: { readonly [event: string]: v.GenericSchema } = Object.fromEntries(
  Object.entries(codeBook).map(([event, { fields }]) => [
    event,
    v.strictObject({ ...schemaOf(everyLine), event: v.literal(event), ...schemaOf(fields) }),
  ]),
)

/** A line stands in a session that has begun, is of its child, and no earlier than the line before. */
function fitting(line: Line, sessions: Map<string, Session>): Line {
  const { session: id, pseudonym, t } = line
  const before = sessions.get(id)
  if (line.event === 'session' && !before) sessions.set(id, { pseudonym, t, ticks: 0 })
  const session = sessions.get(id)
  if (!session) throw new LineError('noSession', { session: id })
  if (session.pseudonym !== pseudonym) throw new LineError('otherChild', { session: id })
  if (t < session.t) throw new LineError('timeBack')
  session.t = t
  if (line.event === 'time') session.ticks += line.ticks
  if (session.ticks > most.ticks) throw new LineError('tooMuchTime')
  return line
}
