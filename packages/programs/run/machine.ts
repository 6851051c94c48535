import type { Facts, Frame, Next, Value } from '@botgarten/blocks'
import type { Thread } from '../types.ts'
import { leaveFrame, resetFrame, takeFrame, type FreeFrames } from './frames.ts'
import type { IndexedBlock, ProgramIndex } from './index-program.ts'
import type { Running } from './memory.ts'

/** running.md 3 */
export const blocksPerTick = 1000

/** So many functions may be on their way at once. */
const mostCalls = 500

/** A thread at work. `nodes` stands beside the thread's frames; everything that lasts is in the thread. */
export interface Machine {
  thread: Thread
  readonly index: ProgramIndex
  readonly context: Running
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
      if (next.cost !== undefined) machine.thread.spent += next.cost
      return node.isValue ? handUp(machine, frame, next.value) : goBelow(machine, node, frame)
    case 'call':
      return call(machine, node, next.name, next.args)
    case 'return':
      return returnFrom(machine, node, next.value)
    case 'leave':
      return leave(machine, node, next.how)
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
  if (node.decides) thread.decisions++
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
  const node = machine.nodes[machine.nodes.length - 1]
  if (node?.isFunction) machine.thread.scopes.pop()
  pop(machine)
  leaveFrame(machine.free, frame, value)
  const parent = machine.thread.frames[machine.thread.frames.length - 1]
  if (parent) parent.got.push(value ?? null)
  else machine.result = value
  return machine.thread.spent > blocksPerTick ? 'over' : 'go'
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

function call(machine: Machine, node: IndexedBlock, name: string, args: readonly Value[]): Outcome {
  const { thread, index } = machine
  const called = index.functions.get(name)
  if (!called) return stop(thread, node.block.id, 'problem.noSuchFunction', { name })
  if (called.parameters.length > args.length) return stop(thread, node.block.id, 'problem.missingValue')
  if (thread.scopes.length > mostCalls) return stop(thread, node.block.id, 'problem.tooManyCalls', { name })
  thread.scopes.push(
    Object.fromEntries(called.parameters.map((parameter, k) => [parameter, args[k] ?? null])),
  )
  push(machine, called.block)
  return begin(machine, called.block)
}

/** Depth of the innermost frame of which this holds; −1 where a function or the program ends before. */
function depthOf(machine: Machine, found: (node: IndexedBlock) => boolean): number {
  for (let depth = machine.nodes.length - 1; depth >= 0; depth--) {
    const node = machine.nodes[depth]
    if (!node || found(node)) return node ? depth : -1
    if (node.isFunction) return -1
  }
  return -1
}

function popTo(machine: Machine, depth: number): void {
  while (machine.thread.frames.length > depth + 1) {
    const frame = machine.thread.frames[machine.thread.frames.length - 1]
    pop(machine)
    if (frame) leaveFrame(machine.free, frame, undefined)
  }
}

function returnFrom(machine: Machine, node: IndexedBlock, value: Value | undefined): Outcome {
  const depth = depthOf(machine, ({ isFunction }) => isFunction)
  if (depth < 0) return stop(machine.thread, node.block.id, 'problem.notInFunction')
  popTo(machine, depth)
  const frame = machine.thread.frames[depth]
  return frame ? handUp(machine, frame, value) : 'ended'
}

function leave(machine: Machine, node: IndexedBlock, how: 'loop' | 'pass'): Outcome {
  const depth = depthOf(machine, ({ definition }) => definition.loops === true)
  if (depth < 0) return stop(machine.thread, node.block.id, 'problem.notInLoop')
  popTo(machine, depth)
  const loop = machine.nodes[depth]
  const frame = machine.thread.frames[depth]
  if (how === 'pass' || !loop || !frame) return 'go'
  return goBelow(machine, loop, frame)
}

function stop(thread: Thread, block: string, problem: string, facts?: Facts): Outcome {
  thread.problem = { block, problem, ...(facts && { facts }), stops: true }
  return 'ended'
}
