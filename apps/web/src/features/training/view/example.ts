import type { Settings, TrainTrace } from '@botgarten/learning/neural-network/train'
import { m } from '#words/message.ts'
import { number } from './messages.ts'

export interface ShownOutput {
  readonly id: string
  /** In percent. */
  readonly shown: number
  readonly says: number
}

export const outputsIn = ({ neurons }: TrainTrace): readonly ShownOutput[] =>
  neurons.flatMap(({ id, target, value }) =>
    target === undefined ? [] : [{ id, shown: 100 * target, says: 100 * value }],
  )

/** "16 too little". */
export function offWords(shown: number, says: number): string {
  const off = Math.round(shown) - Math.round(says)
  if (off === 0) return m['training.right']()
  const by = number(Math.abs(off), 0)
  return off > 0 ? m['training.tooLittle']({ by }) : m['training.tooMuch']({ by })
}

/** A factor of the step at one knob; those that are 1 are left out. */
export interface Factor {
  readonly name: 'speed' | 'outputs' | 'error' | 'passedBack' | 'slope' | 'input' | 'mean'
  readonly value: number
}

/**
 * What a step at a knob is multiplied from: step = rate × (2 ÷ outputs) × error × slope × input, a hidden neuron's error being
 * what comes back to it. With several examples in a batch it is this example's share of their mean.
 */
export function factorsOf(
  trace: TrainTrace,
  { rate, batch }: Pick<Settings, 'rate' | 'batch'>,
  [from, to]: readonly [string, string],
  shares: boolean,
): readonly Factor[] {
  const link = trace.links.find((one) => one.from === from && one.to === to)
  const neuron = trace.neurons.find(({ id }) => id === to)
  if (!link || !neuron) return []
  const outputs = trace.neurons.filter(({ target }) => target !== undefined).length
  const isOutput = neuron.target !== undefined
  const slope = shares && isOutput ? 1 : neuron.slope
  const passedBack = slope === 0 ? 0 : 0 - neuron.delta / slope
  const error: Factor = isOutput
    ? { name: 'error', value: neuron.target - neuron.value }
    : { name: 'passedBack', value: passedBack }
  const all: readonly Factor[] = [
    { name: 'speed', value: rate },
    { name: 'outputs', value: isOutput && !shares ? 2 / outputs : 1 },
    error,
    { name: 'slope', value: slope },
    { name: 'input', value: link.input },
    { name: 'mean', value: 1 / Math.max(1, trace.examples === 0 ? batch : trace.examples) },
  ]
  const kept: readonly Factor['name'][] = ['speed', 'error', 'passedBack', 'input']
  return all.filter(({ name, value }) => kept.includes(name) || value !== 1)
}

/** What the step at a knob is by the chosen method, for experts. η, μ, λ: speed, momentum, decay; m̂ and v̂ as Adam has them. */
export function formulaOf({
  optimizer,
  momentum,
  decay,
}: Pick<Settings, 'optimizer' | 'momentum' | 'decay'>): string {
  const slope = decay === 0 ? '∂L/∂w' : '(∂L/∂w + λ·w)'
  if (optimizer === 'adam') return 'Δw = −η · m̂ ÷ (√v̂ + ε)'
  return momentum === 0 ? `Δw = −η · ${slope}` : `v ← μ·v + ${slope}, Δw = −η · v`
}

/** The gradient of one example at a knob, from what is passed back to its sum and what comes in. */
export function gradientOf(trace: TrainTrace, [from, to]: readonly [string, string]): string {
  const link = trace.links.find((one) => one.from === from && one.to === to)
  const neuron = trace.neurons.find(({ id }) => id === to)
  if (!link || !neuron) return ''
  const [delta, input, gradient] = [neuron.delta, link.input, link.gradient].map((value) => number(value, 4))
  return `∂L/∂w = ∂L/∂z · x = ${delta} · ${input} = ${gradient}`
}

export const productOf = (factors: readonly Factor[]): number =>
  factors.reduce((product, { value }) => product * value, 1)
