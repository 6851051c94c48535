import { activations } from '../types.ts'
import { BLOCK, type Block } from './block.ts'
import { sumOne } from './forward-block.ts'
import type { Layer, Practice } from './types.ts'

const [, RELU, SIGMOID, TANH, THRESHOLD] = activations.map((_, code) => code)

/** `backwardOver` of the next examples in the order, which ran last: adds ∂L/∂w to the gradient. */
export function backwardBlock(practice: Practice, size: number): void {
  const { layers } = practice.net
  outputDeltas(practice, layers[layers.length - 1]!, size)
  for (let l = layers.length - 1; l >= 0; l--) {
    addGradient(practice, layers[l]!, size)
    if (l > 0) backLayer(practice, layers[l]!, size)
  }
}

/** δ = (2/m)(y − t)·f′(z). */
function outputDeltas({ block, net, practised, order, at }: Practice, layer: Layer, size: number): void {
  const { to, outputs } = layer
  const { values, deltas } = block
  const { targets } = practised
  for (let j = 0; j < outputs; j++) {
    const z = (to + j) * BLOCK
    for (let r = 0; r < size; r++) {
      const off = values[z + r]! - targets[order[at + r]! * outputs + j]!
      deltas[z + r] = (2 * off) / outputs
    }
    slopeIn(block, net.activations[to + j]!, z, size)
  }
}

/** Times f′(z). */
function slopeIn({ sums, values, deltas }: Block, code: number, z: number, size: number): void {
  const end = z + size
  if (code === RELU) for (let r = z; r < end; r++) deltas[r] = deltas[r]! * Number(sums[r]! > 0)
  else if (code === TANH) for (let r = z; r < end; r++) deltas[r] = deltas[r]! * (1 - values[r]! * values[r]!)
  else if (code === SIGMOID)
    for (let r = z; r < end; r++) deltas[r] = deltas[r]! * (values[r]! * (1 - values[r]!))
  else if (code === THRESHOLD) for (let r = z; r < end; r++) deltas[r] = deltas[r]! * 0
}

/** ∂L/∂w = δ·x and ∂L/∂b = δ of one layer of links. */
function addGradient({ block, gradient }: Practice, layer: Layer, size: number): void {
  const { inputs, outputs, from, to, weights, biases } = layer
  const { values, deltas } = block
  let j = 0
  for (; j + 1 < outputs && inputs % 4 === 0; j += 2) {
    const d = (to + j) * BLOCK
    for (let i = 0; i < inputs; i += 4)
      addEight(gradient, deltas, values, weights + j * inputs + i, inputs, d, (from + i) * BLOCK, size)
    addTwoBiases(gradient, deltas, biases + j, d, size)
  }
  for (; j < outputs; j++) {
    const d = (to + j) * BLOCK
    const at = weights + j * inputs
    let i = 0
    for (; i + 3 < inputs; i += 4) addFour(gradient, deltas, values, at + i, d, (from + i) * BLOCK, size)
    for (; i < inputs; i++) addOne(gradient, deltas, values, at + i, d, (from + i) * BLOCK, size)
    addBias(gradient, deltas, biases + j, d, size)
  }
}

/** Of four links to each of two neurons. */
function addEight(
  gradient: Float64Array,
  deltas: Float64Array,
  values: Float64Array,
  at: number,
  inputs: number,
  d: number,
  x: number,
  size: number,
): void {
  const to = at + inputs
  let a = gradient[at]!
  let b = gradient[at + 1]!
  let c = gradient[at + 2]!
  let e = gradient[at + 3]!
  let f = gradient[to]!
  let g = gradient[to + 1]!
  let h = gradient[to + 2]!
  let k = gradient[to + 3]!
  for (let r = 0; r < size; r++) {
    const one = deltas[d + r]!
    const other = deltas[d + BLOCK + r]!
    const p = values[x + r]!
    const q = values[x + BLOCK + r]!
    const s = values[x + 2 * BLOCK + r]!
    const t = values[x + 3 * BLOCK + r]!
    a += one * p
    b += one * q
    c += one * s
    e += one * t
    f += other * p
    g += other * q
    h += other * s
    k += other * t
  }
  gradient[at] = a
  gradient[at + 1] = b
  gradient[at + 2] = c
  gradient[at + 3] = e
  gradient[to] = f
  gradient[to + 1] = g
  gradient[to + 2] = h
  gradient[to + 3] = k
}

/** Of four links. */
function addFour(
  gradient: Float64Array,
  deltas: Float64Array,
  values: Float64Array,
  at: number,
  d: number,
  x: number,
  size: number,
): void {
  let a = gradient[at]!
  let b = gradient[at + 1]!
  let c = gradient[at + 2]!
  let e = gradient[at + 3]!
  for (let r = 0; r < size; r++) {
    const delta = deltas[d + r]!
    a += delta * values[x + r]!
    b += delta * values[x + BLOCK + r]!
    c += delta * values[x + 2 * BLOCK + r]!
    e += delta * values[x + 3 * BLOCK + r]!
  }
  gradient[at] = a
  gradient[at + 1] = b
  gradient[at + 2] = c
  gradient[at + 3] = e
}

function addOne(
  gradient: Float64Array,
  deltas: Float64Array,
  values: Float64Array,
  at: number,
  d: number,
  x: number,
  size: number,
): void {
  let sum = gradient[at]!
  for (let r = 0; r < size; r++) sum += deltas[d + r]! * values[x + r]!
  gradient[at] = sum
}

function addTwoBiases(
  gradient: Float64Array,
  deltas: Float64Array,
  at: number,
  d: number,
  size: number,
): void {
  let one = gradient[at]!
  let other = gradient[at + 1]!
  for (let r = d; r < d + size; r++) {
    one += deltas[r]!
    other += deltas[r + BLOCK]!
  }
  gradient[at] = one
  gradient[at + 1] = other
}

function addBias(gradient: Float64Array, deltas: Float64Array, at: number, d: number, size: number): void {
  let sum = gradient[at]!
  for (let r = d; r < d + size; r++) sum += deltas[r]!
  gradient[at] = sum
}

/** δ of the layer before: f′(zᵢ) Σⱼ wᵢⱼ δⱼ. */
function backLayer({ block, parameters, net }: Practice, layer: Layer, size: number): void {
  const { inputs, outputs, from, to, weights } = layer
  const { deltas } = block
  for (let i = 0; i < inputs; i++) {
    const x = (from + i) * BLOCK
    const at = weights + i
    const d = to * BLOCK
    let j = 0
    if (outputs > 1) {
      setTwo(deltas, parameters[at]!, parameters[at + inputs]!, d, x, size)
      j = 2
    } else for (let r = x; r < x + size; r++) deltas[r] = 0
    for (; j < outputs; j++) sumOne(deltas, deltas, parameters[at + j * inputs]!, d + j * BLOCK, x, size)
    slopeIn(block, net.activations[from + i]!, x, size)
  }
}

/** δ ← 0 + w·δ of two neurons that it leads to. */
function setTwo(deltas: Float64Array, a: number, b: number, d: number, x: number, size: number): void {
  for (let r = 0; r < size; r++) deltas[x + r] = 0 + a * deltas[d + r]! + b * deltas[d + BLOCK + r]!
}
