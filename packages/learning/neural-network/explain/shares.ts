import { fastDraw, fastStream, stream } from '@botgarten/numbers'
import { forward, layOut, weightOf } from '../network.ts'
import type { Brain, Weights } from '../types.ts'

/** What each input brings to one neuron's value: `base` + all shares = `total`. */
export interface Shares {
  /** In the order of the inputs, in the units of the value. */
  readonly shares: readonly number[]
  /** The value with every input 0: what biases give. */
  readonly base: number
  readonly total: number
  /** False where orders of the inputs were drawn instead of counted. */
  readonly counted: boolean
}

/** Inputs up to which all their sets are counted: 4,096 runs of the network. */
const COUNTED = 12
/** Beyond it so many orders of the inputs are drawn, each once forth and once back. */
const ORDERS = 400

/** Value of a game in which the inputs of `players` take part, as bits. */
type Game = (players: number) => number

/**
 * The share of each input in the value of a neuron of any layer (its output, activation included): its Shapley value in the game
 * "inputs take part, the others are 0" (Shapley 1953; for explanations Lundberg & Lee 2017, NeurIPS 30, eq. 4 and 8). Where
 * there is one layer of links without a bend, that is input × weight. Shares add up exactly: efficiency is one of its axioms.
 * With more than 12 inputs that are not 0, orders are drawn (Castro, Gómez & Tejada 2009), the same every time; each order adds up by itself.
 *
 * @param inputs missing ones and NaN count 0
 * @param neuron an unknown one has no value: everything is 0
 */
export function sharesOf(
  brain: Brain,
  inputs: readonly number[],
  neuron: string,
  weights: Weights = brain.weights,
): Shares {
  const given = (brain.layers[0] ?? []).map((_, index) => inputs[index] || 0)
  const value = valueOf(brain, neuron, weights)
  const base = value(given.map(() => 0))
  const total = value(given)
  const products = straight(brain, given, neuron, weights)
  if (products) return { shares: products, base, total, counted: true }
  const players = given.flatMap((input, index) => (input === 0 ? [] : [index]))
  const counted = players.length <= COUNTED
  const shares = given.map(() => 0)
  if (counted) addCounted(shares, players, gameOf(value, given, players))
  else addDrawn(shares, players, value, given)
  return { shares, base, total, counted }
}

/** A neuron's value for given inputs: only the layers up to it are run. */
function valueOf(brain: Brain, neuron: string, weights: Weights): (inputs: readonly number[]) => number {
  const layer = brain.layers.findIndex((one) => one.some(({ id }) => id === neuron))
  if (layer < 0) return () => 0
  const index = brain.layers[layer]!.findIndex(({ id }) => id === neuron)
  const net = layOut({ ...brain, layers: brain.layers.slice(0, layer + 1) }, weights)
  return (inputs) => forward(net, inputs)[index] ?? 0
}

/** Input × weight, where that is all there is to it; null elsewhere. */
function straight({ layers }: Brain, given: readonly number[], neuron: string, weights: Weights) {
  const to = layers[1]?.find(({ id }) => id === neuron)
  if (to?.activation !== 'identity') return null
  return layers[0]!.map(({ id }, index) => given[index]! * weightOf(weights, id, neuron))
}

const gameOf =
  (
    value: (inputs: readonly number[]) => number,
    given: readonly number[],
    players: readonly number[],
  ): Game =>
  (set) =>
    value(given.map((input, index) => ((set >> players.indexOf(index)) & 1 ? input : 0)))

/** φᵢ = Σ over sets S without i: |S|! (n − |S| − 1)! ÷ n! · (v(S + i) − v(S)). */
function addCounted(shares: number[], players: readonly number[], game: Game): void {
  const n = players.length
  const values = Float64Array.from({ length: 1 << n }, (_, set) => game(set))
  const often = oftenOf(n)
  for (let set = 0; set < values.length; set++)
    for (let player = 0; player < n; player++)
      if (((set >> player) & 1) === 0)
        shares[players[player]!]! += often[ones(set)]! * (values[set | (1 << player)]! - values[set]!)
}

/** `often[s]` = s! (n − s − 1)! ÷ n!, for sets of s of n. */
function oftenOf(n: number): readonly number[] {
  const often = [1 / n]
  for (let s = 1; s < n; s++) often.push((often[s - 1]! * s) / (n - s))
  return often
}

function ones(set: number): number {
  let count = 0
  for (let rest = set; rest > 0; rest &= rest - 1) count++
  return count
}

function addDrawn(
  shares: number[],
  players: readonly number[],
  value: (inputs: readonly number[]) => number,
  given: readonly number[],
): void {
  const random = fastStream(stream(0, 'shares'))
  for (let round = 0; round < ORDERS; round++) {
    const order = [...players]
    for (let last = order.length - 1; last > 0; last--) {
      const other = Math.floor(fastDraw(random) * (last + 1))
      ;[order[last], order[other]] = [order[other]!, order[last]!]
    }
    addOrder(shares, order, value, given)
    addOrder(shares, order.reverse(), value, given)
  }
}

function addOrder(
  shares: number[],
  order: readonly number[],
  value: (inputs: readonly number[]) => number,
  given: readonly number[],
): void {
  const inputs = given.map(() => 0)
  let before = value(inputs)
  for (const player of order) {
    inputs[player] = given[player]!
    const after = value(inputs)
    shares[player]! += (after - before) / (2 * ORDERS)
    before = after
  }
}
