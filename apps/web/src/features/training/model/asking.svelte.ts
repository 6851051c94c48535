import { findingsIn, shownPairs, type ExampleFinding } from '@botgarten/learning/neural-network/examples'
import type { Assignment } from './assignment.svelte.ts'
import type { Showing } from './showing.svelte.ts'

/** What Piep asks about the examples: one thing at a time, the gravest first. Nothing is set aside by itself. */
export class Asking {
  readonly #assignment: Assignment
  readonly #showing: Showing
  /** What a child wants to keep as it is. */
  #kept = $state.raw<readonly string[]>([])

  constructor(assignment: Assignment, showing: Showing) {
    this.#assignment = assignment
    this.#showing = showing
  }

  readonly #all: readonly ExampleFinding[] = $derived.by(() => {
    const { examples, net, layers, choice, mirror } = this.#assignment
    if (!examples || !net) return []
    const [inputs, outputs] = [net.inputs, net.outputs].map((all) => all.map(({ id }) => id)) as [
      string[],
      string[],
    ]
    const { pairs } = shownPairs(examples, inputs, outputs)
    if (pairs.length === 0 || pairs.length > mostAsked) return []
    return findingsIn({
      ...{ pairs, inputs, outputs, wheels: this.#showing.drives },
      mirror: choice.settings.mirror ? mirror : null,
      knobs: knobsIn(layers, choice.settings.bias === 'on'),
    })
  })

  /** The question of now; null: there is none. */
  readonly now = $derived.by(() => this.#all.find((one) => !this.#kept.includes(nameOf(one))) ?? null)

  keep(finding: ExampleFinding): void {
    this.#kept = [...this.#kept, nameOf(finding)]
  }
}

/** To compare each with each takes a child's patience beyond this. */
const mostAsked = 1500

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
