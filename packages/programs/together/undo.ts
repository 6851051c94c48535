import { getIn, same } from './settings.ts'
import type { State } from './state.ts'
import { blocksIn, indexOf } from './tree.ts'
import type { Author, Operation } from './types.ts'

/** What takes an own operation back, and how to know that nobody has gone on from it. */
export interface Back {
  readonly op: Operation
  /** How many entries of the common order its author had seen. */
  readonly since: number
  /** What was done: a value that is another one by now was set by the other. */
  readonly done: Operation
}

const stacksOf = ({ doc }: State, program: string) => doc.programs[program]?.stacks ?? []

/** What takes an operation back, as things stand before it; null: nothing has to be. */
export function backFrom(op: Operation, state: State, since: number): Back | null {
  const back = inverse(op, state)
  return back && { op: back, since, done: op }
}

function inverse(op: Operation, state: State): Operation | null {
  if (op.kind === 'knob' || op.kind === 'thing') {
    const root = op.kind === 'knob' ? state.doc.brains : state.doc.world
    return { ...op, value: getIn(root, op.path) ?? null }
  }
  if (op.kind === 'program') return { ...op, value: state.doc.programs[op.program] ?? null }
  const { program } = op
  if (op.kind === 'add') return { kind: 'delete', program, block: op.block.id }
  const spot = indexOf(stacksOf(state, program)).get(op.block)
  if (!spot) return null
  const { block, place, next } = spot
  if (op.kind === 'field') return { ...op, value: block.fields?.[op.name] ?? null }
  if (op.kind === 'part') return { ...op, value: block[op.name] ?? null }
  const headOf = 'x' in place && next !== null
  if (op.kind === 'delete') return { kind: 'add', program, block, place: headOf ? { before: next } : place }
  return { ...op, place: headOf && !('x' in op.place) ? { before: next } : place }
}

/** Does it undo only what its author has done? */
export function undoesOwn({ op, since, done }: Back, state: State, author: Author): boolean {
  if (done.kind === 'knob' || done.kind === 'thing') {
    const root = done.kind === 'knob' ? state.doc.brains : state.doc.world
    return same(getIn(root, done.path) ?? null, done.value)
  }
  if (done.kind === 'program' || op.kind === 'program' || op.kind === 'knob' || op.kind === 'thing')
    return true
  const block = indexOf(stacksOf(state, done.program)).get(op.kind === 'add' ? op.block.id : op.block)?.block
  if (op.kind === 'add') return true
  if (!block) return false
  if (done.kind === 'field') return (block.fields?.[done.name] ?? null) === done.value
  if (done.kind === 'part') return same(block[done.name] ?? null, done.value)
  const other = author === 'a' ? 'b' : 'a'
  const meant = op.kind === 'delete' ? blocksIn(block) : [block]
  return meant.every(({ id }) => (state.touched.get(`${done.program}/${id}`)?.[other] ?? -1) < since)
}
