import { exp, tanh } from '@botgarten/numbers'
import { activations } from '../types.ts'
import type { Layer, TrainNet } from './types.ts'

const [IDENTITY, RELU, SIGMOID, TANH, THRESHOLD, SOFTMAX] = activations.map((_, code) => code)

/** Where a run writes, and with what it runs. */
interface Run {
  readonly net: TrainNet
  readonly parameters: Float64Array
  readonly sums: Float64Array
  readonly values: Float64Array
}

/** One run of the network over a row of inputs: z = b + Σ w·x, y = f(z), values in hundredths (model.md). */
export function forwardOver(run: Run, inputs: Float64Array, row: number): void {
  const { net, values } = run
  const width = net.layers[0]?.inputs ?? 0
  for (let i = 0; i < width; i++) values[i] = inputs[row * width + i]!
  for (let l = 0; l < net.layers.length; l++) runLayer(run, net.layers[l]!)
}

function runLayer({ net, parameters, sums, values }: Run, layer: Layer): void {
  const { inputs, outputs, from, to, biases } = layer
  const codes = net.activations
  let at = layer.weights
  for (let j = 0; j < outputs; j++) {
    let sum = parameters[biases + j]!
    for (let i = 0; i < inputs; i++) sum += parameters[at++]! * values[from + i]!
    sums[to + j] = sum
    values[to + j] = activated(codes[to + j]!, sum)
  }
  if (outputs > 0 && codes[to] === SOFTMAX) share(sums, values, to, outputs)
}

/** f(z) of a neuron on its own. */
function activated(code: number, sum: number): number {
  if (code === RELU) return sum > 0 ? sum : 0
  if (code === TANH) return tanh(sum)
  if (code === SIGMOID) return 1 / (1 + exp(-sum))
  return code === THRESHOLD ? (sum > 0 ? 1 : 0) : sum
}

/** f′(z), from z and y = f(z). A threshold has none: 0. Softmax practises with cross-entropy, whose slope is in its δ. */
export function slopeOf(code: number, sum: number, value: number): number {
  if (code === RELU) return sum > 0 ? 1 : 0
  if (code === TANH) return 1 - value * value
  if (code === SIGMOID) return value * (1 - value)
  return code === IDENTITY ? 1 : 0
}

/** exp(zᵢ) / Σ exp(zⱼ), from the largest down so that nothing overflows. */
function share(sums: Float64Array, values: Float64Array, at: number, count: number): void {
  let most = -Infinity
  for (let j = at; j < at + count; j++) if (sums[j]! > most) most = sums[j]!
  let all = 0
  for (let j = at; j < at + count; j++) all += values[j] = exp(sums[j]! - most)
  for (let j = at; j < at + count; j++) values[j] = values[j]! / all
}
