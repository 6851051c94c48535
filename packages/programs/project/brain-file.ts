import {
  activations,
  biasRow,
  pruneWeights,
  withActivation,
  type Activation,
  type Brain,
  type Weights,
} from '@botgarten/learning/neural-network/brain'
import { mostNeurons } from '@botgarten/blocks'
import * as v from 'valibot'
import type { NetworkOutline } from '../types.ts'
import { isReserved, refuseOversize } from './limits.ts'
import { finite, idSchema, recordOf } from './schema-program.ts'

// A brain as a file of its own: weights by name, and what its neurons are, so that it is known where it fits.

type Problem =
  'notJson' | 'tooBig' | 'notABrain' | 'isAProject' | 'notANumber' | 'tooManyNeurons' | 'otherProgram'

/** Why a brain cannot be taken. `facts` are for the words `net.refused.<problem>`. */
export class BrainError extends Error {
  override readonly name = 'BrainError'
  readonly problem: Problem
  readonly facts: { readonly [name: string]: string | number }

  constructor(problem: Problem, facts: BrainError['facts'] = {}) {
    super(problem)
    this.problem = problem
    this.facts = facts
  }
}

const mostLetters = 2_000_000
const longestName = 40
/** A weight of a child's or of a training is far smaller. */
const greatest = 1e6

const weight = v.pipe(finite, v.minValue(-greatest), v.maxValue(greatest))
const neuron = v.object({ id: idSchema, kind: idSchema, activation: v.picklist(activations) })
const schema = v.object({
  botgarten: v.literal('brain'),
  version: v.literal(1),
  name: v.pipe(v.string(), v.maxLength(200)),
  layers: v.pipe(v.array(v.array(neuron)), v.minLength(2), v.maxLength(mostNeurons)),
  weights: recordOf(recordOf(weight)),
})
/** `kind`: type of the neuron's block, `hidden` for those between. */
export type BrainFile = v.InferOutput<typeof schema>

const hiddenKind = 'hidden'

/** A brain's weights as a file. `weights`: those that are meant, with their biases. */
export function brainFile(name: string, brain: Brain, net: NetworkOutline, weights: Weights): BrainFile {
  const kinds = new Map([...net.inputs, ...net.outputs].map(({ id, type }) => [id, type]))
  const layers = brain.layers.map((layer) =>
    layer.map(({ id, activation }) => ({ id, kind: kinds.get(id) ?? hiddenKind, activation })),
  )
  const own = Object.fromEntries(
    brain.layers.flat().flatMap(({ id, bias }) => (bias === 0 ? [] : [[id, bias] as const])),
  )
  const pruned = pruneWeights(
    { ...brain, layers: withoutOwnBias(brain) },
    {
      ...weights,
      [biasRow]: { ...own, ...weights[biasRow] },
    },
  )
  return { botgarten: 'brain', version: 1, name, layers, weights: pruned }
}

const withoutOwnBias = ({ layers }: Brain) =>
  layers.map((layer) => layer.map((neuron) => ({ ...neuron, bias: 0 })))

/** A brain from a file's text, of which nothing is trusted. @throws {BrainError} and nothing else */
export function parseBrainFile(text: string): BrainFile {
  if (text.length > mostLetters) throw new BrainError('tooBig')
  const data = dataIn(text)
  refuseShape(data)
  const { success, output, issues } = v.safeParse(schema, data, { abortEarly: true })
  if (success) return { ...output, name: freeOfSpace(output.name) }
  const inWeights = issues[0].path?.[0]?.key === 'weights' && issues[0].path.length === 3
  throw new BrainError(inWeights ? 'notANumber' : 'notABrain')
}

function dataIn(text: string): unknown {
  let data: unknown
  try {
    data = JSON.parse(text)
  } catch {
    // JSON knows no such number; who writes one means one.
    const odd = /[:,[]\s*-?(NaN|Infinity)\b/.test(text) && /"brain"/.test(text)
    throw new BrainError(odd ? 'notANumber' : 'notJson')
  }
  try {
    refuseOversize(data)
  } catch {
    throw new BrainError('notABrain')
  }
  return data
}

function refuseShape(data: unknown): void {
  if (typeof data !== 'object' || data === null) throw new BrainError('notABrain')
  const { botgarten, layers } = data as { botgarten?: unknown; layers?: unknown }
  if (typeof botgarten === 'number') throw new BrainError('isAProject')
  if (!Array.isArray(layers)) throw new BrainError('notABrain')
  const count = layers.reduce<number>((sum, layer) => sum + (Array.isArray(layer) ? layer.length : 0), 0)
  if (count > mostNeurons) throw new BrainError('tooManyNeurons', { count, most: mostNeurons })
}

/** A name that a saved brain can have. */
export function shelfName(name: string, taken: readonly string[], fallback: string): string {
  const plain = freeOfSpace(name).slice(0, longestName).trim() || fallback
  const base = isReserved(plain) ? fallback : plain
  for (let number = 1; ; number++) {
    const tried = number === 1 ? base : `${base} ${number}`
    if (!taken.includes(tried)) return tried
  }
}

const freeOfSpace = (name: string) => name.replace(/\s+/g, ' ').trim()

/**
 * The weights of a file under the names of this network: neurons that are called the same, or else stand in the same
 * place and are of the same kind. With them come the activations of the outputs.
 * @throws {BrainError} `otherProgram` where the network has other layers
 */
export function fitBrain(
  file: BrainFile,
  brain: Brain,
  net: NetworkOutline,
): { brain: Brain; weights: Weights } {
  const here = brainFile('', brain, net, {}).layers
  const sizes = (layers: BrainFile['layers']) => layers.map((layer) => layer.length).join(' → ')
  const refuse = () => new BrainError('otherProgram', { there: sizes(file.layers), here: sizes(here) })
  if (sizes(file.layers) !== sizes(here)) throw refuse()
  const last = here.length - 1
  const names = new Map<string, string>([[biasRow, biasRow]])
  file.layers.forEach((layer, l) => {
    const own = here[l]!
    const named = layer.every(({ id, kind }) => own.some((one) => one.id === id && one.kind === kind))
    layer.forEach(({ id, kind, activation }, k) => {
      const same = named ? own.find((one) => one.id === id)! : own[k]!
      if (same.kind !== kind || (l < last && same.activation !== activation)) throw refuse()
      names.set(id, same.id)
    })
  })
  return { brain: withOutputs(brain, file, names), weights: renamed(file.weights, names) }
}

function withOutputs(brain: Brain, file: BrainFile, names: ReadonlyMap<string, string>): Brain {
  const said = new Map<string, Activation>(
    file.layers.at(-1)!.map(({ id, activation }) => [names.get(id)!, activation]),
  )
  const outputs = brain.layers.at(-1)!
  if (outputs.every(({ id, activation }) => said.get(id) === activation)) return brain
  const shared = [...said.values()].includes('softmax')
  return outputs.reduce((all, { id }) => withActivation(all, id, shared ? 'softmax' : said.get(id)!), brain)
}

const renamed = (weights: Weights, names: ReadonlyMap<string, string>): Weights =>
  Object.fromEntries(
    Object.entries(weights).flatMap(([from, row]) => {
      const own = names.get(from)
      if (own === undefined) return []
      const entries = Object.entries(row).flatMap(([to, weight]) => {
        const name = names.get(to)
        return name === undefined ? [] : [[name, weight] as const]
      })
      return [[own, Object.fromEntries(entries)]]
    }),
  )
