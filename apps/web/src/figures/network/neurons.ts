import type { Track } from '#drawing/track.ts'
import type { NeuronOutline } from '@botgarten/programs'
import type { RobotConfig } from '@botgarten/simulation'
import { message } from '#words/message.ts'
import { colourOf, labelOf, placeOf, shortLabelOf } from './words.ts'

/** A neuron as it is drawn. */
export interface Neuron {
  readonly id: string
  readonly label: string
  readonly place: string | null
  /** The whole label and the place in one, for the ear. */
  readonly name: string
  readonly colour: string
  readonly missing: boolean
  /** What is written below it is its place alone. */
  readonly bare?: boolean
}

/** @param layer all neurons of its layer */
export function drawn(
  neuron: NeuronOutline,
  config: RobotConfig,
  problems: ReadonlySet<string>,
  layer: readonly NeuronOutline[] = [],
): Neuron {
  const label = labelOf(neuron)
  const key = placeOf(neuron, config)
  const place = key === null ? null : message(key)
  return {
    id: neuron.id,
    label: shortLabelOf(neuron, layer),
    place,
    name: place === null ? label : message('network.name', { label, place }),
    colour: colourOf(neuron),
    missing: problems.has(neuron.id),
  }
}

/** The links as they are drawn, by the ids of their ends. */
export type Links = readonly { readonly from: string; readonly to: string; readonly track: Track }[]
