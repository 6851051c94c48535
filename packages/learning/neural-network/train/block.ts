import type { Practice, Rows, TrainNet } from './types.ts'

// Several examples at once, neuron by neuron (forward-block.ts, backward-block.ts): each sum and each slope still adds its terms in
// the order of links and of examples, so that every bit is that of one example after the other. It is faster, since weights stay in
// registers and the values of a neuron lie side by side.

/** So many examples at most; their values stay in the nearest cache. */
export const BLOCK = 16
/** Fewer are done faster one by one. */
const LEAST = 4

/** By neuron `BLOCK` numbers, one for each example: z, y = f(z), δ. */
export interface Block {
  readonly sums: Float64Array
  readonly values: Float64Array
  readonly deltas: Float64Array
}

export const blockFor = ({ count }: TrainNet): Block => ({
  sums: new Float64Array(count * BLOCK),
  values: new Float64Array(count * BLOCK),
  deltas: new Float64Array(count * BLOCK),
})

/** Examples that can be done at once now: at most to the end of the batch and of the round. 0: they go one by one. */
export function blockSize({ net, settings, order, at, inBatch }: Practice): number {
  if (net.shares) return 0
  const size = Math.min(settings.batch - inBatch, order.length - at, BLOCK)
  return size < LEAST ? 0 : size
}

/** Takes up the inputs of the next examples in the order. */
export function takeNext({ block, practised, net, order, at }: Practice, size: number): void {
  const width = net.layers[0]!.inputs
  for (let r = 0; r < size; r++) takeRow(block, practised, width, order[at + r]!, r)
}

/** Takes up the inputs of rows as they stand in their table. */
export function takeRows(block: Block, rows: Rows, width: number, from: number, size: number): void {
  for (let r = 0; r < size; r++) takeRow(block, rows, width, from + r, r)
}

function takeRow({ values }: Block, { inputs }: Rows, width: number, row: number, r: number): void {
  for (let i = 0; i < width; i++) values[i * BLOCK + r] = inputs[row * width + i]!
}
