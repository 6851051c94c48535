import { exp, tanh } from '@botgarten/numbers'
import type { Activation, Neuron } from './types.ts'

/** Each works on sum ÷ 100 and gives × 100: 100 is the full ring. */
const alone: { readonly [name in Exclude<Activation, 'softmax'>]: (sum: number) => number } = {
  identity: (sum) => sum,
  relu: (sum) => (sum > 0 ? sum : 0),
  threshold: (sum) => (sum > 0 ? 100 : 0),
  /** Logistic function of sum ÷ 100, times 100 (Goodfellow, Bengio, Courville 2016, 3.10). */
  sigmoid: (sum) => 100 / (1 + exp(-sum / 100)),
  tanh: (sum) => 100 * tanh(sum / 100),
}

/** A layer's sums become its outputs, in place. */
export function activate(neurons: readonly Neuron[], sums: number[]): void {
  let shared = false
  for (let k = 0; k < neurons.length; k++) {
    const { activation } = neurons[k]!
    if (activation === 'softmax') shared = true
    else sums[k] = alone[activation](sums[k]!)
  }
  if (shared) softmax(neurons, sums)
}

/** 100 · exp(sᵢ/100) / Σ exp(sⱼ/100) (4.1), computed from the largest down so that nothing overflows. */
function softmax(neurons: readonly Neuron[], sums: number[]): void {
  const shares = (k: number) => neurons[k]!.activation === 'softmax'
  let most = -Infinity
  for (let k = 0; k < neurons.length; k++) if (shares(k)) most = Math.max(most, sums[k]!)
  let all = 0
  for (let k = 0; k < neurons.length; k++) if (shares(k)) all += sums[k] = exp((sums[k]! - most) / 100)
  for (let k = 0; k < neurons.length; k++) if (shares(k)) sums[k] = (sums[k]! / all) * 100
}
