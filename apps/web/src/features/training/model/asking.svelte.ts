import {
  findingsIn,
  lossesOn,
  shownPairs,
  type ExampleFinding,
  type Table,
} from '@botgarten/learning/neural-network/examples'
import { errorsByRow, type ErrorsByRow } from './order.ts'
import type { Practice } from './practice.svelte.ts'
import type { Showing } from './showing.svelte.ts'
import type { Solo } from './solo.svelte.ts'

/** To compare more rows takes longer than a frame: that is done beside the page. */
const mostAtOnce = 600
/** ms that a table rests before it is sent there. */
const rest = 150

/** What Piep asks about the examples: one thing at a time, the gravest first. Nothing is set aside by itself. */
export class Asking {
  readonly #practice: Practice
  readonly #showing: Showing
  readonly #solo: Solo
  /** What a child wants to keep as it is. */
  #kept = $state.raw<readonly string[]>([])
  #answered = $state.raw<readonly ExampleFinding[]>([])
  #number = 0
  #timer: ReturnType<typeof setTimeout> | undefined

  constructor(practice: Practice, showing: Showing, solo: Solo) {
    this.#practice = practice
    this.#showing = showing
    this.#solo = solo
  }

  /** The examples that practise, as the checks look at them; null: there are none. */
  readonly #table: Table | null = $derived.by(() => {
    const { examples, net, layers, choice, mirror, outcome, knobs } = this.#practice
    if (!examples || !net) return null
    const [inputs, outputs] = [net.inputs, net.outputs].map((all) => all.map(({ id }) => id)) as [
      string[],
      string[],
    ]
    const { pairs } = shownPairs(examples, inputs, outputs)
    if (pairs.length === 0) return null
    const hasPractised = outcome.round > 0 && knobs.stands
    return {
      ...{ pairs, inputs, outputs, wheels: this.#showing.drives },
      mirror: choice.settings.mirror ? mirror : null,
      knobs: knobsIn(layers, choice.settings.bias === 'on'),
      failed: this.#solo.failed,
      ...(hasPractised ? { errors: lossesOn(layers, knobs.weights, pairs) } : {}),
    }
  })

  /** By row of the table: how far off it is after practice, as the mean square; null: nothing was practised. */
  readonly errors: ErrorsByRow | null = $derived.by(() => this.#table && errorsByRow(this.#table))

  readonly #isLarge = $derived.by(() => (this.#table?.pairs.length ?? 0) > mostAtOnce)
  readonly #all: readonly ExampleFinding[] = $derived.by(() => {
    if (this.#isLarge) return this.#answered
    return this.#table ? findingsIn(this.#table) : []
  })

  /** Has a large table looked through as soon as it rests. */
  look(): void {
    clearTimeout(this.#timer)
    const [table, isLarge] = [this.#table, this.#isLarge]
    const number = ++this.#number
    this.#answered = []
    if (!table || !isLarge) return
    this.#timer = setTimeout(() => {
      this.#practice.ask(number, table, (answer) => {
        if (answer.number === this.#number) this.#answered = answer.findings
      })
    }, rest)
  }

  /** The question of now; null: there is none. */
  readonly now = $derived.by(() => this.#all.find((one) => !this.#kept.includes(nameOf(one))) ?? null)

  keep(finding: ExampleFinding): void {
    this.#kept = [...this.#kept, nameOf(finding)]
  }
}

/** A question is the same as long as what it asks about is. */
const nameOf = (finding: ExampleFinding): string =>
  finding.kind === 'few' || finding.kind === 'sleeping' || finding.kind === 'oneSided'
    ? finding.kind
    : JSON.stringify(finding)

function knobsIn(layers: readonly (readonly unknown[])[], withBias: boolean): number {
  return layers
    .slice(1)
    .reduce((sum, layer, at) => sum + layer.length * (layers[at]!.length + (withBias ? 1 : 0)), 0)
}
