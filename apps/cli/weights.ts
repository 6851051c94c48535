import { readFileSync } from 'node:fs'
import { brainsFor, type Document } from '@botgarten/lab'
import { FileError } from './errors.ts'

type Weights = { readonly [from: string]: { readonly [to: string]: number } }

/**
 * The document with the weights of a JSON file on its first network's knobs: `{"from": {"to": 0.8}}` with the ids of
 * the neuron blocks. Links that the file does not name become 0.
 */
export function withWeights(document: Document, path: string): Document {
  const weights = readWeights(path)
  const brains = brainsFor(document.programs, document.brains)
  const [id, brain] = Object.entries(brains)[0] ?? []
  if (!id || !brain) throw new FileError('The program has no network that could take weights.')
  const [inputs = [], outputs = []] = brain.layers.map((layer) => layer.map((neuron) => neuron.id))
  for (const [from, row] of Object.entries(weights))
    for (const to of Object.keys(row))
      if (!inputs.includes(from) || !outputs.includes(to))
        throw new FileError(
          `"${path}" names the link ${from}→${to}; there are ${inputs.join(', ')} → ${outputs.join(', ')}.`,
        )
  return { ...document, brains: { ...brains, [id]: { ...brain, weights } } }
}

function readWeights(path: string): Weights {
  let json: unknown
  try {
    json = JSON.parse(readFileSync(path, 'utf8'))
  } catch (error) {
    throw new FileError(`"${path}" cannot be read: ${(error as Error).message}`)
  }
  if (!isWeights(json)) throw new FileError(`"${path}" is not of the form {"from": {"to": 0.8}}.`)
  return json
}

const isObject = (value: unknown): value is { [key: string]: unknown } =>
  typeof value === 'object' && value !== null && !Array.isArray(value)

const isWeights = (json: unknown): json is Weights =>
  isObject(json) &&
  Object.values(json).every(
    (row) => isObject(row) && Object.values(row).every((weight) => typeof weight === 'number'),
  )
