import { exp, tanh } from '@botgarten/numbers'
import { activations } from '../types.ts'
import { BLOCK } from './block.ts'
import type { Layer, Practice } from './types.ts'

const [, RELU, SIGMOID, TANH, THRESHOLD] = activations.map((_, code) => code)

type BlockRun = Pick<Practice, 'net' | 'parameters' | 'block'>

/** `forwardOver` for the rows that were taken up. Not for outputs that share 100. */
export function forwardBlock(run: BlockRun, size: number): void {
  const { layers } = run.net
  for (let l = 0; l < layers.length; l++) forwardLayer(run, layers[l]!, size)
}

function forwardLayer({ block, parameters, net }: BlockRun, layer: Layer, size: number): void {
  const { inputs, outputs, from, to, weights, biases } = layer
  const { sums, values } = block
  const x = from * BLOCK
  let j = 0
  for (; j + 1 < outputs; j += 2) {
    const z = (to + j) * BLOCK
    const at = weights + j * inputs
    beginSums(sums, parameters, biases + j, z, size)
    let i = 0
    for (; i + 3 < inputs; i += 4) sumEight(sums, values, parameters, at + i, inputs, x + i * BLOCK, z, size)
    for (; i < inputs; i++) {
      sumOne(sums, values, parameters[at + i]!, x + i * BLOCK, z, size)
      sumOne(sums, values, parameters[at + inputs + i]!, x + i * BLOCK, z + BLOCK, size)
    }
  }
  for (; j < outputs; j++) {
    const z = (to + j) * BLOCK
    for (let r = z; r < z + size; r++) sums[r] = parameters[biases + j]!
    for (let i = 0; i < inputs; i++)
      sumOne(sums, values, parameters[weights + j * inputs + i]!, x + i * BLOCK, z, size)
  }
  for (j = 0; j < outputs; j++) {
    const z = (to + j) * BLOCK
    activate(sums, values, net.activations[to + j]!, z, z + size)
  }
}

/** z of two neurons ← their biases. */
function beginSums(
  sums: Float64Array,
  parameters: Float64Array,
  bias: number,
  z: number,
  size: number,
): void {
  const one = parameters[bias]!
  const other = parameters[bias + 1]!
  for (let r = z; r < z + size; r++) {
    sums[r] = one
    sums[r + BLOCK] = other
  }
}

/** z ← z + Σ w·x over four links to each of two neurons. */
function sumEight(
  sums: Float64Array,
  values: Float64Array,
  parameters: Float64Array,
  at: number,
  inputs: number,
  x: number,
  z: number,
  size: number,
): void {
  const a = parameters[at]!
  const b = parameters[at + 1]!
  const c = parameters[at + 2]!
  const d = parameters[at + 3]!
  const e = parameters[at + inputs]!
  const f = parameters[at + inputs + 1]!
  const g = parameters[at + inputs + 2]!
  const h = parameters[at + inputs + 3]!
  for (let r = 0; r < size; r++) {
    const p = values[x + r]!
    const q = values[x + BLOCK + r]!
    const s = values[x + 2 * BLOCK + r]!
    const t = values[x + 3 * BLOCK + r]!
    sums[z + r] = sums[z + r]! + a * p + b * q + c * s + d * t
    sums[z + BLOCK + r] = sums[z + BLOCK + r]! + e * p + f * q + g * s + h * t
  }
}

/** z ← z + w·x of one link. */
export function sumOne(
  sums: Float64Array,
  values: Float64Array,
  weight: number,
  x: number,
  z: number,
  size: number,
): void {
  for (let r = 0; r < size; r++) sums[z + r] = sums[z + r]! + weight * values[x + r]!
}

function activate(sums: Float64Array, values: Float64Array, code: number, z: number, end: number): void {
  if (code === TANH) tanhOver(sums, values, z, end)
  else if (code === SIGMOID) sigmoidOver(sums, values, z, end)
  // Without a branch, which would often be guessed wrong; + 0 makes −0 what it is in one run: 0.
  else if (code === RELU) for (let r = z; r < end; r++) values[r] = sums[r]! * Number(sums[r]! > 0) + 0
  else if (code === THRESHOLD) for (let r = z; r < end; r++) values[r] = sums[r]! > 0 ? 1 : 0
  else for (let r = z; r < end; r++) values[r] = sums[r]!
}

function tanhOver(sums: Float64Array, values: Float64Array, from: number, end: number): void {
  for (let r = from; r < end; r++) values[r] = tanh(sums[r]!)
}

function sigmoidOver(sums: Float64Array, values: Float64Array, from: number, end: number): void {
  for (let r = from; r < end; r++) values[r] = 1 / (1 + exp(-sums[r]!))
}
