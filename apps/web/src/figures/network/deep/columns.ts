import { biasOf, hiddenId, type Brain, type Weights } from '@botgarten/learning/neural-network'
import type { HiddenOutline } from '@botgarten/programs'
import { language } from '#words/language.svelte.ts'
import { message } from '#words/message.ts'
import { formatNumber } from '#drawing/numbers.ts'
import type { Neuron } from '../neurons.ts'

const violet = '#6F55C4'

/** The neurons of a hidden layer as they are drawn, under the names that hints use; `index` counts layers from 0. */
export const hiddenColumn = ({ id, neurons }: HiddenOutline, index: number): Neuron[] =>
  Array.from({ length: neurons }, (_, k) => {
    const label = message('net.hidden', { layer: index + 1, neuron: k + 1 })
    return {
      id: hiddenId(id, k + 1),
      label,
      place: label,
      name: label,
      colour: violet,
      missing: false,
      bare: true,
    }
  })

/** A node that has a bias, or more to do than to hand its sum on, says so below it. */
export function dressed(neuron: Neuron, brain: Brain | undefined, weights: Weights): Neuron {
  const own = brain?.layers.flat().find(({ id }) => id === neuron.id)
  if (!own) return neuron
  const bias = biasOf(weights, own)
  const notes = [
    ...(neuron.place === null ? [] : [neuron.place]),
    ...(own.activation === 'identity' || neuron.bare ? [] : [message(`net.activation.${own.activation}`)]),
    ...(bias === 0 ? [] : [signed(bias)]),
  ]
  return { ...neuron, place: notes.length > 0 ? notes.join(' · ') : null }
}

const signed = (value: number) => (value > 0 ? '+' : '') + formatNumber(value, language.locale)

const parts: ReadonlyMap<number, string> = new Map([
  [0, 'none'],
  [0.25, 'quarter'],
  [0.5, 'half'],
  [0.75, 'threeQuarters'],
  [1, 'all'],
])

/** "half of 60", for children who have no decimals yet. */
export function partOf(weight: number, value: string): string {
  const name = parts.get(weight)
  if (name) return message(`net.part.${name}`, { value })
  const tenths = formatNumber(weight * 10, language.locale)
  return message('net.part.tenths', { tenths, value })
}
