import type { Practice } from './types.ts'

const BETA1 = 0.9
const BETA2 = 0.999
const EPSILON = 1e-8
/** A movement below it changes no weight, but to go on with it in ever smaller numbers is slow. */
const TINY = 1e-290

/** Changes the weights by the mean gradient of the batch, which begins anew. */
export function update(practice: Practice): void {
  if (practice.settings.optimizer === 'adam') adam(practice)
  else descend(practice)
  practice.inBatch = 0
  if (practice.settings.range === 'unit') keepInUnit(practice)
}

/** v ← μv + g, w ← w − ηv (Polyak 1964, as PyTorch's SGD). */
function descend({ settings, parameters, gradient, velocity, moves, decay, inBatch }: Practice): void {
  const { rate, momentum } = settings
  const count = parameters.length
  // Of 2, 4, 8 … examples the mean is the same to the last bit by a product, which is quicker.
  const share = 1 / inBatch
  const isExact = (inBatch & (inBatch - 1)) === 0
  for (let k = 0; k < count; k++) {
    const weight = parameters[k]!
    const mean = isExact ? gradient[k]! * share : gradient[k]! / inBatch
    const v = momentum * velocity[k]! + (mean + decay[k]! * weight) * moves[k]!
    velocity[k] = Math.abs(v) < TINY ? 0 : v
    parameters[k] = weight - rate * v
    gradient[k] = 0
  }
}

/** Kingma & Ba 2015, algorithm 1, with both bias corrections. */
function adam(practice: Practice): void {
  const { settings, parameters, gradient, velocity, squares, moves, decay, inBatch } = practice
  practice.beta1 *= BETA1
  practice.beta2 *= BETA2
  const rate = settings.rate / (1 - practice.beta1)
  const spread = 1 - practice.beta2
  for (let k = 0; k < parameters.length; k++) {
    const slope = (gradient[k]! / inBatch + decay[k]! * parameters[k]!) * moves[k]!
    const first = BETA1 * velocity[k]! + (1 - BETA1) * slope
    const second = BETA2 * squares[k]! + (1 - BETA2) * slope * slope
    velocity[k] = Math.abs(first) < TINY ? 0 : first
    squares[k] = second < TINY ? 0 : second
    parameters[k] = parameters[k]! - (rate * first) / (Math.sqrt(second / spread) + EPSILON)
    gradient[k] = 0
  }
}

/** Weights alone: a bias has no knob of 0 to 1. */
function keepInUnit({ net, parameters }: Practice): void {
  for (const { weights, biases } of net.layers)
    for (let k = weights; k < biases; k++) parameters[k] = Math.min(1, Math.max(0, parameters[k]!))
}
