import { forward, layOut, weightOf } from '../network.ts'
import type { Brain, Weights } from '../types.ts'

/** One link that would have to be another. */
export interface Change {
  readonly from: string
  readonly to: string
  readonly before: number
  readonly after: number
}

/** What a network decides, read from its outputs in their order: −1, 0 or 1. */
export type Decision = (outputs: readonly number[]) => number

/** Which wheel is faster, from motor speeds (cut to −100..100): 1 the first, −1 the second, 0 both alike. Indices of outputs. */
export const fasterOf =
  (first: number, second: number): Decision =>
  (outputs) =>
    Math.sign(speed(outputs[first]) - speed(outputs[second]))

const speed = (value = 0) => Math.max(-100, Math.min(100, value))

/** Is an output above its threshold? 1 or −1. */
export const aboveOf =
  (output: number, threshold = 0): Decision =>
  (outputs) =>
    (outputs[output] ?? 0) > threshold ? 1 : -1

/** Forward or backward? Where it stands: 0. */
export const signOf =
  (output: number): Decision =>
  (outputs) =>
    Math.sign(outputs[output] ?? 0)

/** Weights are tried in steps of a hundredth. */
const STEPS = 100
/** Runs of the network between two pauses. */
const SLICE = 500

interface Range {
  readonly least: number
  readonly most: number
}

/**
 * The smallest change of one weight that turns a decision round (1 becomes −1, −1 becomes 1, 0 becomes either): every link,
 * every hundredth, nearest first. Of changes of one size the first link by layer, neuron and source wins, and up before down.
 * A weight outside the range may come towards it. Pauses every 500 runs, so that a screen can go on meanwhile.
 * @returns null where no single weight within the range does it
 */
export function* smallestChange(
  brain: Brain,
  inputs: readonly number[],
  decision: Decision,
  { least, most }: Range = { least: 0, most: 1 },
  weights: Weights = brain.weights,
): Generator<undefined, Change | null> {
  const net = layOut(brain, weights)
  const was = decision(forward(net, inputs))
  const turned = (now: number) => (was === 0 ? now !== 0 : now === -was)
  const links = linksOf(brain, weights, { least, most })
  const farthest = Math.max(0, ...links.map(({ low, high, before }) => Math.max(high - before, before - low)))
  let runs = 0
  for (let step = 1; step <= Math.ceil(farthest * STEPS); step++)
    for (const { layer, row, column, low, high, ...link } of links)
      for (const way of [1, -1]) {
        const after = stepped(link.before, step * way)
        if (after < low || after > high) continue
        const into = net.layers[layer]!.weights[row]!
        into[column] = after
        const found = turned(decision(forward(net, inputs)))
        into[column] = link.before
        if (found) return { ...link, after }
        if (++runs % SLICE === 0) yield
      }
  return null
}

/** In millionths: steps of weights that were turned by hand are hundredths to the last bit. */
const stepped = (weight: number, steps: number) => Math.round(weight * 1e6 + (steps * 1e6) / STEPS) / 1e6

function linksOf({ layers }: Brain, weights: Weights, { least, most }: Range) {
  return layers.slice(1).flatMap((to, layer) =>
    to.flatMap(({ id }, row) =>
      layers[layer]!.map((from, column) => {
        const before = weightOf(weights, from.id, id)
        const range = { low: Math.min(least, before), high: Math.max(most, before) }
        return { from: from.id, to: id, before, layer, row, column, ...range }
      }),
    ),
  )
}
