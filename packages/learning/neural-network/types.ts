import type { Examples } from './examples/types.ts'
import type { CurvePoint } from './train/practise.ts'
import type { Settings } from './train/types.ts'

/** One neuron. Its `id` is the id of the block it stands for, so that links keep their weights while blocks are edited. */
export interface Neuron {
  readonly id: string
  readonly activation: Activation
  /** Added to the weighted sum before the activation, in the units of the sum, unless the weights say another one. */
  readonly bias: number
}

/**
 * What becomes of a neuron's sum s. `identity`: s · `relu`: s above 0, else 0 · `threshold`: 100 above 0, else 0 ·
 * `sigmoid`, `tanh`: of s ÷ 100, times 100 · `softmax`: the neurons of a layer that have it share 100 ("which of these").
 */
export type Activation = (typeof activations)[number]
export const activations = ['identity', 'relu', 'sigmoid', 'tanh', 'threshold', 'softmax'] as const

/**
 * `weights[from][to]`, 0 where nothing is written. Links of removed neurons stay written, so that undo finds them.
 * The row `#bias` (`biasRow`) holds biases that were set by hand; they stand in for the neuron's own.
 */
export type Weights = { readonly [fromId: string]: { readonly [toId: string]: number } }

/** A feed-forward, fully connected network: layers from input to output. Plain frozen data. */
export interface Brain {
  readonly kind: 'network'
  readonly layers: readonly (readonly Neuron[])[]
  readonly weights: Weights
  /** Named weight sets of the same network. */
  readonly sets: { readonly [name: string]: Weights }
  /** What it was shown. */
  readonly examples?: Examples
  readonly practice?: PracticeNote
}

/** How it practised last: from start, examples and seed it practises again, the same every time. */
export interface PracticeNote {
  readonly seed: number
  readonly start: Weights
  readonly settings: Settings & {
    readonly keepBack: number
    readonly from: 'knobs' | 'zero'
    readonly mirror: boolean
  }
  readonly round: number
  readonly curve: readonly CurvePoint[]
  /** Rounds to go back to. */
  readonly marks: readonly number[]
  /** What was chosen since, for the next practice. */
  readonly next?: Pick<PracticeNote, 'seed' | 'settings'>
}

/** How one output came about: a term a link, `product = input × weight`. */
export interface Term {
  readonly from: string
  readonly to: string
  readonly input: number
  readonly weight: number
  readonly product: number
}

/** One run of a network, opened: every term, every neuron's sum before its activation, every output after it. */
export interface NetTrace {
  readonly terms: readonly Term[]
  /** What each neuron behind the inputs adds to its terms: sum = bias + Σ products, to the last bit. */
  readonly biases: { readonly [neuronId: string]: number }
  readonly sums: { readonly [neuronId: string]: number }
  readonly outputs: { readonly [neuronId: string]: number }
}
