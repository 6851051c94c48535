import { exp, tanh } from '@botgarten/numbers'
import type { Curves } from './activations.ts'
import type { Neuron } from './types.ts'

/** Logistic function of sum ÷ 100, times 100 (Goodfellow, Bengio, Courville 2016, 3.10). */
const sigmoid = (sum: number): number => 100 / (1 + exp(-sum / 100))

/** 100 · exp(sᵢ/100) / Σ exp(sⱼ/100) (4.1), computed from the largest down so that nothing overflows. */
function softmax(neurons: readonly Neuron[], sums: number[]): void {
  const shares = (k: number) => neurons[k]!.activation === 'softmax'
  let most = -Infinity
  for (let k = 0; k < neurons.length; k++) if (shares(k)) most = Math.max(most, sums[k]!)
  let all = 0
  for (let k = 0; k < neurons.length; k++) if (shares(k)) all += sums[k] = exp((sums[k]! - most) / 100)
  for (let k = 0; k < neurons.length; k++) if (shares(k)) sums[k] = (sums[k]! / all) * 100
}

export const curves: Curves = { sigmoid, tanh: (sum) => 100 * tanh(sum / 100), softmax }
