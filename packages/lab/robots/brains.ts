import {
  biasOf,
  emptyBrain,
  forward,
  layOut,
  weightsOf,
  type Brain,
  type Net,
  type Weights,
} from '@botgarten/learning/neural-network/brain'
import { brainFor, networks, type Program } from '@botgarten/programs'
import type { RobotPlacement } from '@botgarten/simulation'

export type Brains = { readonly [networkId: string]: Brain }

/** Brains for every network block of these programs; their neurons follow the blocks, their weights stay (running.md 11). */
export function brainsFor(programs: { readonly [id: string]: Program }, brains: Brains): Brains {
  const next: { [id: string]: Brain } = { ...brains }
  for (const network of Object.values(programs).flatMap(networks))
    next[network.id] = brainFor(network, brains[network.id])
  return next
}

/** The weights a robot drives with: those on the knobs, or one named set. */
export const weightsFor = (brain: Brain, placement: RobotPlacement): Weights =>
  weightsOf(brain, placement.brain)

/** One run of a network: what it read, and the brain it ran with. */
export interface NetRun {
  readonly inputs: readonly number[]
  readonly brain: Brain
  /** Simulated seconds at its tick. */
  readonly now: number
}

/** The networks of one robot, ready to run, with the last run of each. */
export class RobotBrains {
  readonly #placement: RobotPlacement
  readonly #nets = new Map<string, Net>()
  readonly #brains = new Map<string, Brain>()
  /** By network block. */
  readonly lastRuns = new Map<string, NetRun>()
  /** How many runs there have been, for stepping from run to run. */
  runs = 0

  constructor(placement: RobotPlacement, brains: Brains) {
    this.#placement = placement
    for (const [id, brain] of Object.entries(brains)) this.use(id, brain)
  }

  /** A brain with other weights or neurons takes the place of the one before. */
  use(id: string, brain: Brain): void {
    this.#brains.set(id, brain)
    this.#nets.set(id, layOut(brain, weightsFor(brain, this.#placement)))
  }

  /** A brain with other examples and the same weights. */
  shown(id: string, brain: Brain): void {
    this.#brains.set(id, brain)
  }

  /** A brain with the weights this robot drives with, and the biases among them in its neurons. */
  brain(id: string): { layers: Brain['layers']; weights: Weights } | undefined {
    const brain = this.#brains.get(id)
    if (!brain) return undefined
    const weights = weightsFor(brain, this.#placement)
    const layers = brain.layers.map((layer) =>
      layer.map((neuron) => ({ ...neuron, bias: biasOf(weights, neuron) })),
    )
    return { layers, weights }
  }

  /** One run of a network. Unknown networks give nothing. */
  think(id: string, inputs: readonly number[], now: number): readonly number[] {
    this.runs++
    this.lastRuns.set(id, { inputs: inputs.slice(), brain: this.#brains.get(id) ?? emptyBrain, now })
    return this.would(id, inputs)
  }

  /** What a run would give, without being one. */
  would(id: string, inputs: readonly number[]): readonly number[] {
    const net = this.#nets.get(id)
    return net ? forward(net, inputs) : []
  }
}
