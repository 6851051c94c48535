import { backwardOver } from './backward.ts'
import { backwardBlock } from './backward-block.ts'
import { blockSize, takeNext } from './block.ts'
import { lossOf } from './errors.ts'
import { forwardBlock } from './forward-block.ts'
import { forwardOver, slopeOf } from './forward.ts'
import { eachParameter } from './layout.ts'
import { biasRow } from '../network.ts'
import { finishRound } from './round.ts'
import type { Practice, TrainTrace } from './types.ts'
import { update } from './update.ts'

/** One example: run, error, slopes; with the last of a batch the weights change. Allocates nothing but what is traced. */
export function step(practice: Practice, trace?: (trace: TrainTrace) => void): void {
  if (practice.ended !== null) return
  const row = practice.order[practice.at]!
  forwardOver(practice, practice.practised.inputs, row)
  backwardOver(practice, row)
  practice.at++
  practice.inBatch++
  const isWhole = practice.at === practice.order.length
  const changes = isWhole || practice.inBatch === practice.settings.batch
  const before = trace ? practice.parameters.slice() : null
  const examples = changes ? practice.inBatch : 0
  if (changes) update(practice)
  if (trace) trace(opened(practice, row, before!, examples))
  if (isWhole) finishRound(practice)
}

/** The next examples, several at once where that is faster: bit for bit what `step` would do. Returns how many they were. */
export function stepSome(practice: Practice): number {
  if (practice.ended !== null) return 0
  const size = blockSize(practice)
  if (size === 0) {
    step(practice)
    return 1
  }
  takeNext(practice, size)
  forwardBlock(practice, size)
  backwardBlock(practice, size)
  practice.at += size
  practice.inBatch += size
  const isWhole = practice.at === practice.order.length
  if (isWhole || practice.inBatch === practice.settings.batch) update(practice)
  if (isWhole) finishRound(practice)
  return size
}

/** Practises to the end of this round; does nothing when practice is over. */
export function finishThisRound(practice: Practice): void {
  const { round } = practice
  while (practice.ended === null && practice.round === round) stepSome(practice)
}

function opened(practice: Practice, row: number, before: Float64Array, examples: number): TrainTrace {
  const { round, practised } = practice
  const loss = lossOf(practice, practised, row)
  return {
    round,
    row,
    loss,
    neurons: openedNeurons(practice, row),
    links: openedLinks(practice, before),
    examples,
  }
}

function openedNeurons(practice: Practice, row: number): TrainTrace['neurons'] {
  const { net, sums, values, deltas, practised } = practice
  const { to = 0, outputs = 0 } = net.layers.at(-1) ?? {}
  const inputs = net.layers[0]?.inputs ?? 0
  return net.neurons.flat().map(({ id }, at) => {
    const isInput = at < inputs
    const [sum, value] = [isInput ? values[at]! : sums[at]!, values[at]!]
    const slope = isInput ? 1 : slopeOf(net.activations[at]!, sum, value)
    const delta = isInput ? 0 : deltas[at]! + 0
    const opened = { id, sum, value, slope, delta }
    return at < to ? opened : { ...opened, target: practised.targets[row * outputs + at - to]! }
  })
}

function openedLinks(practice: Practice, before: Float64Array): TrainTrace['links'] {
  const { net, parameters, values, deltas } = practice
  const place = new Map(net.neurons.flat().map(({ id }, at) => [id, at]))
  const links: TrainTrace['links'][number][] = []
  eachParameter(net, (at, from, to) => {
    const input = from === null ? 1 : values[place.get(from)!]!
    const gradient = deltas[place.get(to)!]! * input + 0
    links.push({ from: from ?? biasRow, to, input, gradient, before: before[at]!, after: parameters[at]! })
  })
  return links
}
