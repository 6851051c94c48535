import type { Context, Value } from '@botgarten/blocks'
import type { Thread } from '../types.ts'
import { takeFrame } from './frames.ts'
import type { IndexedBlock, ProgramIndex } from './index-program.ts'
import { blocksPerTick, step, type Machine, type Outcome } from './machine.ts'

const threadFrom = (node: IndexedBlock | null): Thread => ({
  frames: node ? [takeFrame([], node.block.id)] : [],
  lit: null,
  started: 0,
  acts: 0,
  spent: node ? 1 : 0,
  overAt: -1,
  ended: false,
  problem: null,
})

/** A program at its start block. Nothing has run yet. */
export const startThread = (index: ProgramIndex): Thread => threadFrom(index.start)

/** One machine a program: what it keeps between ticks is only memory to use again. */
const machines = new WeakMap<ProgramIndex, Machine>()

function machineOf(thread: Thread, index: ProgramIndex, context: Context): Machine {
  const kept = machines.get(index)
  const machine = kept ?? { thread, context, nodes: [], free: [], result: undefined }
  if (!kept) machines.set(index, machine)
  machine.thread = thread
  machine.context = context
  findNodes(machine, index)
  return machine
}

/** Frames are data and name their blocks; a block that is gone ends the thread. */
function findNodes({ thread, nodes }: Machine, { blocks }: ProgramIndex): void {
  nodes.length = 0
  for (const { block } of thread.frames) {
    const node = blocks.get(block)
    if (node) nodes.push(node)
  }
  if (nodes.length < thread.frames.length) thread.frames.length = 0
}

/**
 * Runs a thread to the end of the tick that `context.now` names (semantics.md). With `untilNextBlock` it stops already
 * where a statement block has been begun, which the next call carries out.
 * @returns Is the tick over for this thread? Called again in the same tick it has nothing more to do.
 */
export function runThread(
  thread: Thread,
  index: ProgramIndex,
  context: Context,
  untilNextBlock = false,
): boolean {
  if (thread.ended || thread.overAt === context.now) return true
  const machine = machineOf(thread, index, context)
  let outcome: Outcome
  do outcome = step(machine)
  while (outcome === 'go' || (outcome === 'lit' && !untilNextBlock))
  if (outcome === 'lit') return false
  if (outcome === 'ended') end(thread, context)
  endTick(thread, context)
  return true
}

/** A block that was begun beyond the budget counts for the next tick. */
function endTick(thread: Thread, context: Context): void {
  thread.spent = thread.spent > blocksPerTick ? 1 : 0
  thread.overAt = context.now
}

/** Rule 4: the program's end stops the motors; a tone without end falls silent, the lamp and the display stay. */
function end(thread: Thread, { robot }: Context): void {
  thread.frames.length = 0
  thread.lit = null
  thread.ended = true
  robot.stop()
  robot.tone(0, null)
}

/**
 * The value of a value block right now, without a running program: what a sensor reads, what a layer gives.
 * null where the block is unknown, gives nothing or cannot go on.
 */
export function evaluate(index: ProgramIndex, blockId: string, context: Context): Value {
  const node = index.blocks.get(blockId)
  if (!node?.isValue) return null
  // The blocks inside a value block are finite, so that it needs no budget.
  const thread = { ...threadFrom(node), spent: -Infinity }
  const machine: Machine = { thread, context, nodes: [node], free: [], result: undefined }
  let outcome: Outcome
  do outcome = step(machine)
  while (outcome === 'go')
  return machine.result ?? null
}
