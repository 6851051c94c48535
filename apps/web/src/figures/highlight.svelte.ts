import { getContext, setContext } from 'svelte'
import type { NeuronOutline } from '@botgarten/programs'

/** A part of Bo: `motor C`, `sensor 2`, `lamp`. */
export type Part = string

/** Where a hand is: on a block, on a node, on a part of Bo. */
export type Place = 'block' | 'node' | 'part'

interface Lit {
  readonly place: Place
  readonly neurons: readonly string[]
  readonly part: Part | null
}

/** The part of Bo that a neuron stands for; null where it has none that is seen. */
export function partOf({ type, fields, look }: NeuronOutline): Part | null {
  if (type === 'ai_nn_output_node_led') return 'lamp'
  // `ULTRASONIC_PORT_2` and `MOTORPORT_C` end with their port.
  const port = look.port && fields[look.port]?.at(-1)
  return port ? `${look.layer === 'output' ? 'motor' : 'sensor'} ${port}` : null
}

/** What lights up together: a neuron's block, its node, and the wheel, eye or lamp of Bo. */
export class Highlight {
  readonly #neurons: () => readonly NeuronOutline[]
  readonly #robot: () => string
  #pointed = $state.raw<Lit | null>(null)
  #touched = $state.raw<Lit | null>(null)
  get touched() {
    return this.#touched
  }

  /** What is pointed at, else what was touched last. */
  readonly now = $derived(this.#pointed ?? this.#touched)

  /** @param neurons of the network that is shown; @param robot id of the robot it belongs to */
  constructor(neurons: () => readonly NeuronOutline[], robot: () => string) {
    this.#neurons = neurons
    this.#robot = robot
  }

  #neuron(place: Place, id: string | null): Lit | null {
    const neuron = this.#neurons().find((one) => one.id === id)
    return neuron ? { place, neurons: [neuron.id], part: partOf(neuron) } : null
  }

  #part(part: Part | null): Lit | null {
    if (part === null) return null
    const neurons = this.#neurons().filter((neuron) => partOf(neuron) === part)
    return neurons.length > 0 ? { place: 'part', neurons: neurons.map(({ id }) => id), part } : null
  }

  pointAt(place: 'block' | 'node', neuron: string | null): void {
    this.#pointed = this.#neuron(place, neuron)
  }

  touch(place: 'block' | 'node', neuron: string | null): void {
    this.#touched = this.#neuron(place, neuron)
  }

  pointAtPart(part: Part | null): void {
    this.#pointed = this.#part(part)
  }

  touchPart(part: Part | null): void {
    this.#touched = this.#part(part)
  }

  lightsNeuron(id: string): boolean {
    return this.now?.neurons.includes(id) ?? false
  }

  lightsPart(robot: string, part: Part): boolean {
    return this.now?.part === part && robot === this.#robot()
  }
}

const key = Symbol('highlight')

/** Gives the lab's drawings what lights up together. */
export const provideHighlight = (highlight: Highlight): Highlight => setContext(key, highlight)

/** Undefined for a drawing outside the lab: nothing lights up there. */
export const useHighlight = (): Highlight | undefined => getContext<Highlight | undefined>(key)
