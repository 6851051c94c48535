import { biasRow, forward, layOut, trace as traceOf, weightsOf } from '@botgarten/learning/neural-network'
import type { Brain } from '@botgarten/learning/neural-network'
import type { NetView } from '@botgarten/lab'
import type { LabSession } from '#lab/session.svelte.ts'
import { drawn, type Neuron } from '#figures/network/neurons.ts'
import { Asking } from './model/asking.svelte.ts'
import { Comparing } from './model/comparing.svelte.ts'
import { Practice } from './model/practice.svelte.ts'
import { Solo } from './model/solo.svelte.ts'
import { Showing } from './model/showing.svelte.ts'
import { withAllOn, type ShownRow } from './model/table.ts'
import Hand from './view/Hand.svelte'
import Over from './view/Over.svelte'
import Pane from './view/Pane.svelte'

declare module '#lab/slots.ts' {
  interface Slots {
    /** How a network learns from examples. */
    training: Training
  }
}

/** Ways to get weights beside turning knobs by hand. */
export type Way = 'show' | 'practise'

const nothing: ReadonlySet<string> = new Set()

/** Showing examples and practising them: what belongs to it in the pane of the network and in the world. */
export class Training {
  readonly Pane = Pane
  readonly Hand = Hand
  readonly Over = Over
  readonly session: LabSession
  readonly practice: Practice
  readonly showing: Showing
  readonly asking: Asking
  readonly solo: Solo
  readonly comparing: Comparing
  /** null: knobs are turned by hand. */
  way = $state<Way | null>(null)

  constructor(session: LabSession) {
    this.session = session
    this.practice = new Practice(session)
    this.showing = new Showing(this.practice)
    this.solo = new Solo(this.practice)
    this.comparing = new Comparing(this.practice)
    this.asking = new Asking(this.practice, this.showing, this.solo)
  }

  readonly inputs: readonly Neuron[] = $derived.by(() => this.#drawn('inputs'))
  readonly outputs: readonly Neuron[] = $derived.by(() => this.#drawn('outputs'))

  #drawn(layer: 'inputs' | 'outputs'): readonly Neuron[] {
    const { net } = this.practice
    return net?.[layer].map((neuron, _, all) => drawn(neuron, this.session.config, nothing, all)) ?? []
  }

  /** What the neurons say of the example that is open, as far as it has come; null: none is open. */
  readonly example: NetView | null = $derived.by(() => {
    const { beats, brain } = this.practice
    const { chosen } = this.showing
    if (brain && this.way === 'show' && chosen) return this.#ofRow(brain, chosen)
    if (!beats.trace || !brain) return null
    const inputs = beats.trace.neurons.slice(0, this.inputs.length).map(({ value }) => 100 * value)
    const opened = traceOf(brain, beats.shows('inputs') ? inputs : [], this.#weightsBefore)
    const isOutput = (id: string) => this.outputs.some((one) => one.id === id)
    const shown = Object.entries(opened.outputs).filter(([id]) => {
      if (isOutput(id)) return beats.shows('says')
      return this.inputs.some((one) => one.id === id) ? beats.shows('inputs') : beats.shows('sums')
    })
    return { ...opened, outputs: Object.fromEntries(shown), brain, ran: true }
  })

  /** Both knobs of the picture show this example. */
  #ofRow(brain: Brain, { inputs }: ShownRow): NetView {
    const read = inputs.map((value) => value ?? 0)
    return { ...traceOf(brain, read, weightsOf(brain, this.session.robot.brain)), brain, ran: true }
  }

  /** What Bo says to a row's readings, by output; null where the row has gaps. */
  answerTo({ inputs }: ShownRow): readonly number[] | null {
    const { brain } = this.practice
    const read = inputs.filter((value) => value !== null)
    if (!brain || read.length < inputs.length) return null
    return [...forward(layOut(brain, weightsOf(brain, this.session.robot.brain)), read)]
  }

  /** Rows are set aside, or taken back. */
  setOn(rows: readonly number[], on: boolean): void {
    this.showing.change((examples) => withAllOn(examples, rows, on))
  }

  /** Those that Bo has answered with: the knobs move only in the last beat. */
  get #weightsBefore() {
    const { beats, brain } = this.practice
    const weights: { [from: string]: { [to: string]: number } } = {}
    for (const [from, row] of Object.entries(brain ? weightsOf(brain, this.session.robot.brain) : {}))
      weights[from] = { ...row }
    for (const { from, to, before } of beats.trace?.links ?? [])
      (weights[from] ??= {})[to] = from === biasRow ? 100 * before : before
    return weights
  }

  close(): void {
    this.solo.close()
    this.comparing.close()
    this.practice.close()
  }
}
