import { slopeOf } from './forward.ts'
import type { Layer, Practice } from './types.ts'

/**
 * Backpropagation (Goodfellow, Bengio, Courville 2016, algorithm 6.4) of the row that ran last: adds ∂L/∂w = δ·x to the
 * gradient.
 */
export function backwardOver(practice: Practice, row: number): void {
  const { layers } = practice.net
  const last = layers[layers.length - 1]
  if (!last) return
  outputDeltas(practice, last, row)
  for (let l = layers.length - 1; l >= 0; l--) backLayer(practice, layers[l]!, l > 0)
}

/** δ = (2/m)(y − t)·f′(z); with cross-entropy δ = y − t. */
function outputDeltas(practice: Practice, { to, outputs }: Layer, row: number): void {
  const { net, practised, sums, values, deltas } = practice
  for (let j = 0; j < outputs; j++) {
    const off = values[to + j]! - practised.targets[row * outputs + j]!
    const slope = slopeOf(net.activations[to + j]!, sums[to + j]!, values[to + j]!)
    deltas[to + j] = net.shares ? off : ((2 * off) / outputs) * slope
  }
}

/** The gradient of one layer of links, and the δ of the layer before: f′(zᵢ) Σⱼ wᵢⱼ δⱼ. */
function backLayer(practice: Practice, layer: Layer, hidden: boolean): void {
  const { net, parameters, gradient, sums, values, deltas } = practice
  const { inputs, outputs, from, to, weights, biases } = layer
  for (let i = from; i < from + inputs; i++) deltas[i] = 0
  for (let j = 0; j < outputs; j++) {
    const delta = deltas[to + j]!
    if (delta === 0) continue
    gradient[biases + j] = gradient[biases + j]! + delta
    const at = weights + j * inputs
    for (let i = 0; i < inputs; i++) {
      gradient[at + i] = gradient[at + i]! + delta * values[from + i]!
      deltas[from + i] = deltas[from + i]! + parameters[at + i]! * delta
    }
  }
  if (!hidden) return
  for (let i = from; i < from + inputs; i++)
    deltas[i] = deltas[i]! * slopeOf(net.activations[i]!, sums[i]!, values[i]!)
}
