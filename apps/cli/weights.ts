import { brainsFor, type Document } from '@botgarten/lab'
import { biasRow, type Brain, type Weights } from '@botgarten/learning/neural-network'
import { FileError } from './errors.ts'
import { readText } from './files.ts'
import { message } from './words.ts'

/** In megabytes. */
const tooLarge = 5
/** So many links are named in one sentence. */
const mostNamed = 6

/**
 * The document with the weights of a JSON file on its first network's knobs: `{"from": {"to": 0.8}}` with the ids of
 * the neurons, every link of the network; a row `#bias` where biases are set. Schema: schemas/weights.json.
 */
export function withWeights(document: Document, path: string): Document {
  const weights = readWeights(path)
  const brains = brainsFor(document.programs, document.brains)
  const [id, brain] = Object.entries(brains)[0] ?? []
  if (!id || !brain) throw new FileError('weights.noNetwork')
  const links = linksOf(brain)
  const given = namesIn(weights)
  const allowed = new Set([...links, ...biasesOf(brain)])
  const unknown = given.filter((link) => !allowed.has(link))
  if (unknown.length > 0)
    throw new FileError('weights.unknown', { path, links: listed(unknown), known: listed(links) })
  const missing = links.filter((link) => !given.includes(link))
  if (missing.length > 0) throw new FileError('weights.missing', { path, links: listed(missing) })
  return { ...document, brains: { ...brains, [id]: { ...brain, weights } } }
}

const nameOf = (from: string, to: string) => `${from}→${to}`

/** All links, layer by layer, as running.md 11 names them. */
const linksOf = ({ layers }: Brain) =>
  layers.flatMap((layer, index) =>
    layer.flatMap((from) => (layers[index + 1] ?? []).map((to) => nameOf(from.id, to.id))),
  )

const biasesOf = ({ layers }: Brain) =>
  layers.slice(1).flatMap((layer) => layer.map(({ id }) => nameOf(biasRow, id)))

const namesIn = (weights: Weights) =>
  Object.entries(weights).flatMap(([from, row]) => Object.keys(row).map((to) => nameOf(from, to)))

function listed(links: readonly string[]): string {
  const first = links.slice(0, mostNamed).join(', ')
  const count = links.length - mostNamed
  return count > 0 ? message('weights.more', { links: first, count }) : first
}

function readWeights(path: string): Weights {
  const rows = Object.entries(objectIn(jsonIn(path), path))
  for (const [from, row] of rows)
    for (const [to, weight] of Object.entries(objectIn(row, path)))
      if (typeof weight !== 'number' || !Number.isFinite(weight))
        throw new FileError('weights.noNumber', { path, link: nameOf(from, to) })
  return Object.fromEntries<{ [to: string]: number }>(rows)
}

function jsonIn(path: string): unknown {
  try {
    return JSON.parse(readText(path, tooLarge))
  } catch (error) {
    if (error instanceof FileError) throw error
    throw new FileError('file.unreadable', { path, why: message('cause.notJson') })
  }
}

function objectIn(value: unknown, path: string): object {
  if (typeof value === 'object' && value !== null && !Array.isArray(value)) return value
  throw new FileError('weights.shape', { path })
}
