import { stream } from '@botgarten/numbers'
import { emptySorting, type Host, type Value } from '@botgarten/blocks'
import type { Thread } from '../types.ts'
import { takeFrame } from './frames.ts'
import type { IndexedBlock, ProgramIndex } from './index-program.ts'
import { Running } from './memory.ts'
import { blocksPerTick, step, type Machine, type Outcome } from './machine.ts'

const threadFrom = (node: IndexedBlock | null, seed = 0): Thread => ({
  frames: node ? [takeFrame([], node.block.id)] : [],
  lit: null,
  started: 0,
  acts: 0,
  decisions: 0,
  spent: node ? 1 : 0,
  overAt: -1,
  ended: false,
  scopes: [{}],
  random: stream(seed, 'program'),
  net: { inputs: {}, outputs: {}, weights: {}, biases: {} },
  letters: [],
  assertions: { passed: 0, wrong: 0, failed: [] },
  notes: [],
  sorting: emptySorting(),
  problem: null,
})

/** A program at its start block. Nothing has run yet. `seed`: of its random numbers. */
export const startThread = (index: ProgramIndex, seed = 0): Thread => threadFrom(index.start, seed)

/** One machine a program: what it keeps between ticks is only memory to use again. */
const machines = new WeakMap<ProgramIndex, Machine>()

const freshMachine = (thread: Thread, index: ProgramIndex): Machine => ({
  thread,
  index,
  context: new Running(index.networkId),
  nodes: [],
  free: [],
  result: undefined,
})

function machineOf(thread: Thread, index: ProgramIndex, host: Host): Machine {
  const kept = machines.get(index)
  const machine = kept ?? freshMachine(thread, index)
  if (!kept) machines.set(index, machine)
  machine.thread = thread
  machine.context.take(thread, host)
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
 * Runs a thread to the end of the tick that `host.now` names (semantics.md). With `untilNextBlock` it stops already
 * where a statement block has been begun, which the next call executes.
 * @returns Is the tick over for this thread? Called again in the same tick it has nothing more to do.
 */
export function runThread(thread: Thread, index: ProgramIndex, host: Host, untilNextBlock = false): boolean {
  if (thread.ended || thread.overAt === host.now) return true
  const machine = machineOf(thread, index, host)
  let outcome: Outcome
  do outcome = step(machine)
  while (outcome === 'go' || (outcome === 'lit' && !untilNextBlock))
  if (outcome === 'lit') return false
  if (outcome === 'ended') end(thread, host)
  endTick(thread, host)
  return true
}

/** A block that was begun beyond the budget counts for the next tick. */
function endTick(thread: Thread, { now }: Host): void {
  thread.spent = thread.spent > blocksPerTick ? 1 : 0
  thread.overAt = now
}

/** Rule 4: the program's end stops the motors; a tone without end falls silent, the lamp and the display stay. */
function end(thread: Thread, { robot }: Host): void {
  thread.frames.length = 0
  thread.lit = null
  thread.ended = true
  robot.stop()
  robot.tone(0, null)
}

const mostForOne = 100_000

/**
 * The value of a value block right now, without a running program: what a sensor reads, what a layer gives.
 * null where the block is unknown, gives nothing or cannot go on. `given`: what stands in its `got` at its start.
 */
export function evaluate(
  index: ProgramIndex,
  blockId: string,
  host: Host,
  given: readonly Value[] = [],
): Value {
  const node = index.blocks.get(blockId)
  if (!node?.isValue || node.isFunction) return null
  // The biggest net is read at once; a function that does not end is left.
  const thread = { ...threadFrom(node), spent: -mostForOne }
  thread.frames[0]?.got.push(...given)
  const machine = freshMachine(thread, index)
  machine.context.take(thread, host)
  machine.nodes.push(node)
  let outcome: Outcome
  do outcome = step(machine)
  while (outcome === 'go')
  return machine.result ?? null
}
