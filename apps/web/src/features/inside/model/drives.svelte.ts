import { leaveOut, smallestChange, type Change } from '@botgarten/learning/neural-network/explain'
import { biasRow, withWeight, type Brain } from '@botgarten/learning/neural-network'
import { imagine, type Imagined } from '@botgarten/lab/why'
import { level } from '#figures/network/level.svelte.ts'
import type { Inside } from '../inside.svelte.ts'
import { askedOf, type Asked } from './decision.ts'
import { inSlices } from './slices.ts'

/** What the pale robot does otherwise: it leaves an input out, or drives with the smallest change. */
export type Otherwise = { readonly without: string } | 'change' | null

/** The smallest change that turns round what an output decides. */
export interface Turning {
  readonly asked: Asked
  /** What was decided: −1, 0 or 1. */
  readonly was: number
  /** null: no single weight does it. */
  readonly change: Change | null
}

/** Four seconds. */
const TICKS = 240
/** A hand that goes through time or pulls a knob is waited for. */
const CALM = 120

/** From the moment that is shown: how Bo goes on, and how a pale one would. */
export class Drives {
  readonly #inside: Inside
  #otherwise = $state.raw<Otherwise>(null)
  #own = $state.raw<Imagined | null>(null)
  #pale = $state.raw<Imagined | null>(null)
  #turning = $state.raw<Turning | null>(null)
  /** Tick from which on both drive. */
  #from = $state(0)

  constructor(inside: Inside) {
    this.#inside = inside
  }

  get otherwise() {
    return this.#otherwise
  }
  get own() {
    return this.#own
  }
  get pale() {
    return this.#pale
  }
  /** Where the pale robot stands: where Bo drives on, it drives beside it. */
  readonly ghost = $derived.by(() => {
    const { standing, view } = this.#inside
    const poses = this.#pale?.poses ?? []
    const at = standing ? poses.length - 1 : view.tick - this.#from
    return poses[Math.max(0, Math.min(poses.length - 1, at))]
  })
  /** null while it is looked for. */
  get turning() {
    return this.#turning
  }

  /** Shows a pale robot, or none. */
  show(otherwise: Otherwise): void {
    this.#otherwise = otherwise
    if (otherwise === null) this.#pale = null
  }

  /** Follows the moment that is shown, while Bo stands. Returns how to leave off. */
  follow(output: string): () => void {
    const { view, standing, brain, session, net } = this.#inside
    const otherwise = this.#otherwise
    void [view, brain, level.scale]
    if (!standing || !net) return () => {}
    let leave = () => {}
    const wait = setTimeout(() => {
      leave = inSlices(this.#all(output, otherwise, net.id, session.robotId), () => {})
    }, CALM)
    return () => (clearTimeout(wait), leave())
  }

  *#all(output: string, otherwise: Otherwise, net: string, robot: string): Generator<undefined, void> {
    const from = this.#inside.standpoint()
    this.#turning = yield* this.#turn(output)
    const brain = this.#other(otherwise)
    const own = yield* imagine(from, robot, {}, TICKS)
    const pale = brain && (yield* imagine(from, robot, { [net]: brain }, TICKS))
    this.#own = own
    this.#pale = pale
    this.#from = from.moment.tick
  }

  *#turn(output: string): Generator<undefined, Turning | null> {
    const { brain, weights, values, net, session } = this.#inside
    const asked = net && askedOf(net.outputs, output, session.config)
    if (!asked) return null
    const { trace, outputs } = this.#inside
    const was = asked.decision(outputs.map(({ id }) => trace?.outputs[id] ?? 0))
    const range = { ...level.scale, least: Math.min(level.scale.least, ...leastOf(weights)) }
    const change = yield* smallestChange(brain, values, asked.decision, range, weights)
    return { asked, was, change }
  }

  #other(otherwise: Otherwise): Brain | null {
    const { brain, session } = this.#inside
    const set = session.robot.brain
    if (otherwise === null) return null
    if (otherwise !== 'change') return leaveOut(brain, otherwise.without, set)
    const change = this.#turning?.change
    return change ? withWeight(brain, change.from, change.to, change.after, set) : null
  }
}

/** −1 where a weight lies below 0 already, on whatever level. */
const leastOf = (weights: Inside['weights']) =>
  Object.entries(weights).some(([from, row]) => from !== biasRow && Object.values(row).some((one) => one < 0))
    ? [-1]
    : []
