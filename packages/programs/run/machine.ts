import type { Context, Facts, Frame, Next, Value } from '@botgarten/blocks'
import type { Thread } from '../types.ts'
import { leaveFrame, resetFrame, takeFrame, type FreeFrames } from './frames.ts'
import type { IndexedBlock } from './index-program.ts'

/** running.md 3 */
export const blocksPerTick = 1000

/** A thread at work. `nodes` stands beside the thread's frames; everything that lasts is in the thread. */
export interface Machine {
  thread: Thread
  context: Context
  readonly nodes: IndexedBlock[]
  readonly free: FreeFrames
  /** Value of the outermost block, where it is a value block. */
  result: Value | undefined
}

/** go: there is more to do · lit: a statement block was begun · over: the tick is over · ended: nothing is left. */
export type Outcome = 'go' | 'lit' | 'over' | 'ended'

/** One block is asked once. */
export function step(machine: Machine): Outcome {
  const depth = machine.thread.frames.length - 1
  const frame = machine.thread.frames[depth]
  const node = machine.nodes[depth]
  if (!frame || !node) return 'ended'
  return follow(machine, node, frame, node.definition.run(node.block, frame, machine.context))
}

function follow(machine: Machine, node: IndexedBlock, frame: Frame, next: Next): Outcome {
  switch (next.next) {
    case 'value':
      return askFor(machine, node, next.input, next.given)
    case 'statements':
      frame.mark = machine.thread.acts
      return beginRows(machine, node.statements.get(next.input))
    case 'done':
      return node.isValue ? handUp(machine, frame, next.value) : goBelow(machine, node, frame)
    case 'again':
      return machine.thread.acts === frame.mark ? spend(machine.thread) : 'over'
    case 'wait':
      return 'over'
    case 'fail':
      return stop(machine.thread, node.block.id, next.problem, next.facts)
  }
}

/** Semantics 3: what does not fit into this tick's budget is the first thing of the next. */
function spend(thread: Thread): Outcome {
  thread.spent++
  return thread.spent > blocksPerTick ? 'over' : 'go'
}

/** A block is begun. Its frame is on top already. */
function begin({ thread }: Machine, node: IndexedBlock): Outcome {
  if (node.definition.acts) thread.acts++
  if (node.isValue) return spend(thread)
  thread.lit = node.block.id
  thread.started++
  return spend(thread) === 'go' ? 'lit' : 'over'
}

function push(machine: Machine, node: IndexedBlock): Frame {
  const frame = takeFrame(machine.free, node.block.id)
  machine.thread.frames.push(frame)
  machine.nodes.push(node)
  return frame
}

function pop(machine: Machine): void {
  machine.thread.frames.pop()
  machine.nodes.pop()
}

function askFor(machine: Machine, node: IndexedBlock, input: string, given?: readonly Value[]): Outcome {
  const child = node.values.get(input)
  if (!child) return stop(machine.thread, node.block.id, 'problem.missingValue', { input })
  const frame = push(machine, child)
  if (given) for (const value of given) frame.got.push(value)
  return begin(machine, child)
}

function beginRows(machine: Machine, first: IndexedBlock | undefined): Outcome {
  if (!first) return 'go'
  push(machine, first)
  return begin(machine, first)
}

function handUp(machine: Machine, frame: Frame, value: Value | undefined): Outcome {
  pop(machine)
  leaveFrame(machine.free, frame, value)
  const parent = machine.thread.frames[machine.thread.frames.length - 1]
  if (parent) parent.got.push(value ?? null)
  else machine.result = value
  return 'go'
}

function goBelow(machine: Machine, node: IndexedBlock, frame: Frame): Outcome {
  if (!node.below) {
    pop(machine)
    leaveFrame(machine.free, frame, undefined)
    return 'go'
  }
  resetFrame(frame, node.below.block.id)
  machine.nodes[machine.nodes.length - 1] = node.below
  return begin(machine, node.below)
}

function stop(thread: Thread, block: string, problem: string, facts?: Facts): Outcome {
  thread.problem = { block, problem, ...(facts && { facts }), stops: true }
  return 'ended'
}
