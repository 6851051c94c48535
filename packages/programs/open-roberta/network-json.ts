import type { Brain, Neuron } from '@botgarten/learning/neural-network/brain'
import * as v from 'valibot'
import { settingsIn } from './network-settings.ts'
import { idSchema } from '../project/schema-program.ts'

// Today's Open Roberta keeps a network as JSON in the data of a block: names, and weights and biases as texts.

const most = 100
const names = v.pipe(v.array(idSchema), v.maxLength(most))
const layered = v.pipe(v.array(v.array(v.string())), v.maxLength(most))
const schema = v.object({
  activationKey: v.literal('linear'),
  networkShape: v.pipe(v.array(v.number()), v.maxLength(most)),
  weights: v.array(v.array(v.array(v.string()))),
  biases: layered,
  inputs: names,
  outputs: names,
  hiddenNeurons: v.optional(v.array(names)),
})
type Network = v.InferOutput<typeof schema>

function read(data: string): Network | null {
  try {
    const { success, output } = v.safeParse(schema, JSON.parse(data))
    return success ? output : null
  } catch {
    return null
  }
}

/** "1", "-1,0", "-1/15"; "/15" and ":2" are parts of one. Null for what is no number. */
function numberOf(text: string): number | null {
  const [, sign, above, , below] =
    /^\s*([-+]?)(\d+(?:[.,]\d*)?)?(\s*[/:]\s*(\d+(?:[.,]\d*)?))?\s*$/.exec(text) ?? []
  if (above === undefined && below === undefined) return null
  const plain = (digits: string) => Number(digits.replace(',', '.'))
  const size = plain(above ?? '1') / plain(below ?? '1')
  return Number.isFinite(size) ? (sign === '-' ? 0 - size : size) : null
}

/** The number without an exponent, which Open Roberta's network does not read. */
function plain(value: number): string {
  const text = String(value)
  if (!text.includes('e')) return text
  return Math.abs(value) < 1 ? value.toFixed(100).replace(/0+$/, '') : BigInt(value).toString()
}

/** Hidden neurons without names are called as Open Roberta calls them. */
const layersOf = ({
  inputs,
  outputs,
  hiddenNeurons,
  networkShape,
}: Network): readonly (readonly string[])[] => [
  inputs,
  ...networkShape.map(
    (count, layer) =>
      hiddenNeurons?.[layer] ??
      Array.from({ length: Math.min(most, Math.max(0, count)) }, (_, k) => `h${layer + 1}n${k + 1}`),
  ),
  outputs,
]

/** The network in a block's data; null where there is none that this product can compute (linear neurons alone). */
export function networkIn(data: string): Brain | null {
  const network = read(data)
  if (!network) return null
  const layers = layersOf(network)
  const neuron = (id: string, layer: number, k: number): Neuron => ({
    ...{ id, activation: 'identity' },
    bias: numberOf(network.biases[layer]?.[k] ?? '') ?? 0,
  })
  const weights: Record<string, Record<string, number>> = {}
  layers.slice(0, -1).forEach((ids, layer) =>
    ids.forEach((from, k) => {
      const row = network.weights[layer]?.[k] ?? []
      weights[from] = Object.fromEntries(
        layers[layer + 1]!.map((to, at) => [to, numberOf(row[at] ?? '') ?? 0]),
      )
    }),
  )
  const practice = settingsIn(data)
  return {
    kind: 'network',
    layers: layers.map((ids, layer) => ids.map((id, k) => neuron(id, layer, k))),
    weights,
    sets: {},
    ...(practice && { practice }),
  }
}

/** The data with a brain's weights and biases; what says the same number already stays as it is written. */
export function withNetwork(data: string, brain: Brain): string {
  const network = read(data)
  if (!network) return data
  const layers = layersOf(network)
  const said = (text: string | undefined, value: number) =>
    text !== undefined && (numberOf(text) ?? 0) === value ? text : plain(value)
  const weights = layers.map((ids, layer) =>
    ids.map((from, k) =>
      (layers[layer + 1] ?? []).map((to, at) =>
        said(network.weights[layer]?.[k]?.[at], brain.weights[from]?.[to] ?? 0),
      ),
    ),
  )
  const biases = layers.map((ids, layer) =>
    ids.map((id, k) => {
      const neuron = brain.layers[layer]?.find((one) => one.id === id)
      return said(network.biases[layer]?.[k], neuron?.bias ?? 0)
    }),
  )
  const same = JSON.stringify([weights, biases]) === JSON.stringify([network.weights, network.biases])
  return same ? data : JSON.stringify({ ...(JSON.parse(data) as object), weights, biases })
}

/** What Open Roberta writes beside a network that nobody has trained. */
const untrained = {
  ...{ learningRate: 0.03, regularizationRate: 0, noise: 0, batchSize: 10, discretize: false },
  ...{ percTrainData: 50, activationKey: 'linear', activation: {}, regularization: null, initUntil: null },
  ...{ collectStats: false, precision: '2', weightArcMaxSize: 8, weightSuppressMultOp: true },
}

/** A brain whose neurons have Open Roberta's names, as data of the start block. Its neurons all give their sums. */
export function dataFrom({ layers, weights }: Brain): string {
  const ids = layers.map((layer) => layer.map(({ id }) => id))
  const hidden = ids.slice(1, -1)
  return JSON.stringify({
    ...untrained,
    ...{ numHiddenLayers: hidden.length, networkShape: hidden.map(({ length }) => length) },
    weights: ids.map((row, layer) =>
      row.map((from) => (ids[layer + 1] ?? []).map((to) => plain(weights[from]?.[to] ?? 0))),
    ),
    biases: layers.map((layer) => layer.map(({ bias }) => plain(bias))),
    ...{ inputs: ids[0] ?? [], outputs: ids.at(-1) ?? [], hiddenNeurons: hidden },
  })
}
