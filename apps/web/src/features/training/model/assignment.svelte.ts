import type { Brain, Weights } from '@botgarten/learning/neural-network'
import {
  exerciseBy,
  practiceChoice,
  prepare,
  type Exercise,
  type PracticeChoice,
} from '@botgarten/learning/neural-network/examples'
import { obstacleTo } from '@botgarten/learning/neural-network/train'
import type { NetworkInUse } from '@botgarten/programs'
import { mirrorIn } from '@botgarten/programs/examples'
import { steady } from '#drawing/remembered.ts'
import { level } from '#figures/network/level.svelte.ts'
import type { LabSession } from '#lab/session.svelte.ts'
import { Knobs } from './knobs.svelte.ts'
import { presets } from './presets.ts'

/** What the network on the screen is to practise: its examples, and what was chosen. */
export class Assignment {
  readonly session: LabSession
  readonly knobs: Knobs

  constructor(session: LabSession) {
    this.session = session
    this.knobs = new Knobs(this)
  }

  /** The network that the playground shows. */
  readonly net: NetworkInUse | null = $derived.by(() => this.session.outlines[0] ?? null)
  readonly brain: Brain | null = $derived.by(
    () => (this.net && this.session.lab.facts.brains[this.net.id]) ?? null,
  )
  readonly layers = $derived.by(() => this.brain?.layers ?? [])
  readonly examples = $derived.by(() => this.brain?.examples ?? null)
  readonly note = $derived.by(() => this.brain?.practice)
  /** Of the present, whatever moment is shown. */
  readonly #chosen = $derived.by(() => this.net && this.session.lab.document.brains[this.net.id]?.practice)
  readonly #steady = steady<PracticeChoice>()
  /** The same object while it says the same: every report of practice writes the brain, and rows are laid out by this. */
  readonly choice: PracticeChoice = $derived.by(() =>
    this.#steady(
      this.note ? practiceChoice(this.#chosen ? { practice: this.#chosen } : {}) : presets[level.name],
    ),
  )
  /** Which neuron stands for which in a mirror; null: this network has no left and right. */
  readonly mirror = $derived.by(() => (this.net ? mirrorIn(this.net, this.session.config) : null))
  /** What would be practised now. */
  readonly prepared = $derived.by(() => {
    const exercise = this.exercise({})
    return exercise && prepare(exercise)
  })
  /** What keeps it from practising; null: it can. */
  readonly obstacle = $derived.by(() => {
    const { prepared } = this
    if (!prepared || prepared.data.practised.count === 0) return { kind: 'noRows' } as const
    return obstacleTo(prepared.data)
  })

  /** The mirror image of each example is practised, too. */
  get isMirrored(): boolean {
    return this.prepared !== null && this.prepared.data.practised.count > this.prepared.practised.length
  }

  /** What would be practised with these weights as its start; null: there is nothing. */
  exercise(weights: Weights): Exercise | null {
    const { net, layers, examples } = this
    return net && examples && exerciseBy(this.choice, { id: net.id, layers, weights, examples }, this.mirror)
  }

  choose(change: Partial<PracticeChoice['settings']>, seed = this.choice.seed): void {
    if (!this.net) return
    const settings = { ...this.choice.settings, ...change }
    this.knobs.as(() => this.session.examples.choose(this.net!.id, { seed, settings }))
  }
}
