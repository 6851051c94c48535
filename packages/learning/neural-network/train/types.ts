import type { FastStream } from '@botgarten/numbers'
import type { Brain, Weights } from '../types.ts'
import type { Block } from './block.ts'

/** What practice depends on beside its examples and its start. Presets: presets.ts. */
export interface Settings {
  /** Learning rate η. */
  readonly rate: number
  /** μ of gradient descent; Adam has none. */
  readonly momentum: number
  readonly optimizer: 'sgd' | 'adam'
  /** Weight decay λ: of weights, not of biases. */
  readonly decay: number
  /** Examples of which the mean is taken before the weights change. */
  readonly batch: number
  /** It ends after so many rounds; a round is every practised example once. */
  readonly rounds: number
  /** May biases change? */
  readonly bias: 'on' | 'off'
  /** `unit`: weights stay in 0..1. */
  readonly range: 'free' | 'unit'
  readonly order: 'shuffled' | 'table'
  /** Ends when so many rounds have not beaten the best error of what is held back by 1 %; 0: never. */
  readonly patience: number
}

/** Examples as flat numbers in hundredths: `inputs[row * width + neuron]`. */
export interface Rows {
  readonly count: number
  readonly inputs: Float64Array
  readonly targets: Float64Array
}

/** What is practised, and with which network. */
export interface PracticeData {
  readonly layers: Brain['layers']
  /** Where it begins, as on the knobs; biases in the row `#bias`. */
  readonly weights: Weights
  readonly practised: Rows
  /** Held back for a test: never practised. */
  readonly kept: Rows
}

/** One layer of links and the neurons that they lead to. Offsets into the flat arrays of `TrainNet` and `Practice`. */
export interface Layer {
  readonly inputs: number
  readonly outputs: number
  /** Of the values of the layer before, and of its own. */
  readonly from: number
  readonly to: number
  /** Of its weights (by neuron, then by input) and of its biases, in the parameters. */
  readonly weights: number
  readonly biases: number
  readonly last: boolean
}

/** A network laid out for practice. */
export interface TrainNet {
  readonly neurons: Brain['layers']
  readonly layers: readonly Layer[]
  /** Neurons, those of the input layer first. */
  readonly count: number
  readonly parameters: number
  /** By neuron: index in `activations`. */
  readonly activations: Uint8Array
  /** Do its outputs share 100 (softmax)? Then it practises by cross-entropy, else by the mean square. */
  readonly shares: boolean
}

/**
 * Why practice is over. `rounds`: all are done · `noBetter`: the test got no better; the weights are those of round `best` ·
 * `ranAway`: steps were too big; the weights are those of the last whole round.
 */
export type Ending =
  | { readonly kind: 'rounds' }
  | { readonly kind: 'noBetter'; readonly best: number }
  | { readonly kind: 'ranAway'; readonly round: number }

/** Practice on its way. The arrays are used again by every step. */
export interface Practice {
  readonly net: TrainNet
  readonly settings: Settings
  readonly practised: Rows
  readonly kept: Rows
  /** Weights as on the knobs and biases in hundredths, laid out as `Layer` says. */
  readonly parameters: Float64Array
  /** Sum over the examples of the batch so far. */
  readonly gradient: Float64Array
  /** Momentum's velocity; Adam's first moment. */
  readonly velocity: Float64Array
  /** Adam's second moment. */
  readonly squares: Float64Array
  /** 1 where a parameter may change, else 0. */
  readonly moves: Float64Array
  /** λ where decay acts, else 0. */
  readonly decay: Float64Array
  /** Parameters after the last whole round, and after the best one. */
  readonly whole: Float64Array
  readonly best: Float64Array
  /** By neuron: z, y = f(z), δ = ∂L/∂z. */
  readonly sums: Float64Array
  readonly values: Float64Array
  readonly deltas: Float64Array
  /** Of several examples at once. */
  readonly block: Block
  readonly order: Uint32Array
  /** Where the order of the next round begins. */
  readonly stream: FastStream
  /** Where that of this round began. */
  readonly drawn: FastStream
  /** Finished rounds. */
  round: number
  /** The next example in the order, and how many of the batch are done. */
  at: number
  inBatch: number
  /** β₁ᵗ and β₂ᵗ of Adam after t updates. */
  beta1: number
  beta2: number
  bestRound: number
  bestError: number
  ended: Ending | null
}

/** All that practice goes on from. */
export interface SavedPractice {
  readonly parameters: readonly number[]
  readonly gradient: readonly number[]
  readonly velocity: readonly number[]
  readonly squares: readonly number[]
  readonly whole: readonly number[]
  readonly best: readonly number[]
  readonly drawn: readonly number[]
  readonly round: number
  readonly at: number
  readonly inBatch: number
  readonly beta1: number
  readonly beta2: number
  readonly bestRound: number
  /** null: none yet. */
  readonly bestError: number | null
  readonly ended: Ending | null
}

/** One example, opened. Values in hundredths; ids as in the brain. */
export interface TrainTrace {
  readonly round: number
  /** Row of the practised examples. */
  readonly row: number
  readonly loss: number
  readonly neurons: readonly TracedNeuron[]
  readonly links: readonly TracedLink[]
  /** How many examples the weights have just changed for; 0: the batch goes on. */
  readonly examples: number
}

interface TracedNeuron {
  readonly id: string
  /** z, y = f(z), f′(z), ∂L/∂z. */
  readonly sum: number
  readonly value: number
  readonly slope: number
  readonly delta: number
  /** What was shown; of outputs only. */
  readonly target?: number
}

interface TracedLink {
  /** `#bias` for a bias. */
  readonly from: string
  readonly to: string
  readonly input: number
  /** Of this example: δ of `to` × input. */
  readonly gradient: number
  readonly before: number
  readonly after: number
}
