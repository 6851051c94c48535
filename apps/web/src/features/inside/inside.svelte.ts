import { emptyBrain, weightsOf } from '@botgarten/learning/neural-network'
import type { Standpoint } from '@botgarten/lab/why'
import type { Group } from '#drawing/commands.ts'
import { drawn, type Neuron } from '#figures/network/neurons.ts'
import type { LabSession } from '#lab/session.svelte.ts'
import { Drives } from './model/drives.svelte.ts'
import { Field } from './model/field.svelte.ts'
import { paleName } from './view/messages.ts'
import Over from './view/Over.svelte'
import Panel from './view/Panel.svelte'
import Under from './view/Under.svelte'

declare module '#lab/slots.ts' {
  interface Slots {
    /** What is looked at inside the network. */
    inside: Inside
  }
}

export type Page = 'why' | 'function'

const nothing: ReadonlySet<string> = new Set()

/** What a child looks at inside the network: which page is open, and what belongs to it in the world. */
export class Inside {
  readonly Panel = Panel
  readonly Over = Over
  readonly Under = Under
  readonly session: LabSession
  readonly drives: Drives
  readonly field: Field
  /** What Bo would do all over the floor, painted. */
  fieldArrows = $state.raw<Group | null>(null)
  page = $state<Page | null>(null)
  /** The link that was touched last: ids of its two neurons. */
  link = $state.raw<readonly [from: string, to: string] | null>(null)

  constructor(session: LabSession) {
    this.session = session
    this.drives = new Drives(this)
    this.field = new Field(this)
  }

  get view() {
    return this.session.lab.view
  }
  /** The network that the playground shows. */
  readonly net = $derived.by(() => this.session.outlines[0] ?? null)
  readonly trace = $derived.by(() => (this.net && this.view.networks[this.net.id]) || null)
  /** The one whose numbers are shown: while it runs, that of its last run. */
  readonly brain = $derived.by(
    () => this.trace?.brain ?? ((this.net && this.view.brains[this.net.id]) || emptyBrain),
  )
  readonly weights = $derived.by(() => weightsOf(this.brain, this.session.robot.brain))
  /** It has not run so: the numbers are what would be. */
  readonly would = $derived.by(() => this.trace?.ran === false)
  readonly inputs: readonly Neuron[] = $derived.by(
    () => this.net?.inputs.map((neuron, _, all) => drawn(neuron, this.session.config, nothing, all)) ?? [],
  )
  readonly outputs: readonly Neuron[] = $derived.by(
    () => this.net?.outputs.map((neuron) => drawn(neuron, this.session.config, nothing)) ?? [],
  )
  /** What the inputs say. */
  readonly values: readonly number[] = $derived.by(() =>
    this.inputs.map(({ id }) => this.trace?.outputs[id] ?? 0),
  )

  /** The pale robot: where it stands, and what it does otherwise. */
  get ghost() {
    const { ghost: pose, otherwise } = this.drives
    return pose && otherwise ? { id: this.session.robotId, pose, label: paleName(otherwise, this) } : null
  }

  get standing(): boolean {
    return this.view.phase !== 'running'
  }

  /** Where the lab stands: from here a drive can be imagined. */
  standpoint = (): Standpoint => {
    const { document, floor, moment, view } = this.session.lab
    return { document, floor, moment, going: view.phase === 'running' || view.phase === 'paused' }
  }

  close(): void {
    this.page = null
    this.drives.show(null)
  }
}
