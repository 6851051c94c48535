import { m, message } from '#words/message.ts'
import { language } from '#words/language.svelte.ts'
import { formatNumber } from '#drawing/numbers.ts'
import type { Neuron } from '#figures/network/neurons.ts'
import type { Otherwise, Turning } from '../model/drives.svelte.ts'
import type { Inside } from '../inside.svelte.ts'

export const number = (value: number, digits = 2): string => formatNumber(value, language.locale, digits)

/** A neuron's short name: where it sits, if that tells it from its neighbours. */
function shortName({ place, label }: Neuron, layer: readonly Neuron[]): string {
  const alone = place !== null && layer.filter((one) => one.place === place).length === 1
  return alone ? place : label
}

/** A neuron of any layer by its id: inputs by their places, hidden ones by layer and number. */
export function nameIn({ inputs, outputs, brain }: Inside, id: string): string {
  const input = inputs.find((one) => one.id === id)
  if (input) return shortName(input, inputs)
  const output = outputs.find((one) => one.id === id)
  if (output) return output.label
  const layer = brain.layers.findIndex((one) => one.some((neuron) => neuron.id === id))
  const neuron = brain.layers[layer]?.findIndex((one) => one.id === id) ?? 0
  return message('net.hidden', { layer, neuron: neuron + 1 })
}

/** "Why does motor B turn at 45?"; `would`: the network has not run yet. */
export function whyTitle(output: string, value: string, would: boolean, motor: boolean): string {
  const facts = { output, value }
  if (would) return motor ? m['inside.whyWouldTurn'](facts) : m['inside.whyWouldGet'](facts)
  return motor ? m['inside.whyTurns'](facts) : m['inside.whyGets'](facts)
}

/** What stands under the pale robot. */
export function paleName(otherwise: NonNullable<Otherwise>, inside: Inside): string {
  if (otherwise !== 'change') return m['inside.without']({ input: nameIn(inside, otherwise.without) })
  const change = inside.drives.turning?.change
  return change ? m['inside.with']({ weight: number(change.after) }) : ''
}

/** What would be different: "Then Bo turns left." */
export function turned({ asked, was, change }: Turning, output: string): string {
  if (!change) return m[`inside.${asked.kind}Never`]({ output })
  if (asked.kind === 'turn') {
    if (was === 0) return m['inside.turns']()
    return was > 0 ? m['inside.turnsLeft']() : m['inside.turnsRight']()
  }
  if (asked.kind === 'wheel') return m['inside.wheelTurns']({ output })
  return was > 0 ? m['inside.goesOff']({ output }) : m['inside.goesOn']({ output })
}

/** "front right → motor C". */
export const linkName = (from: string, to: string, inside: Inside): string =>
  `${nameIn(inside, from)} → ${nameIn(inside, to)}`
