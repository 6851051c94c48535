import type { Drive } from '@botgarten/learning/neural-network/examples'
import { percentOff, type CurvePoint } from '@botgarten/learning/neural-network/train'
import { formatNumber } from '#drawing/numbers.ts'
import { level } from '#figures/network/level.svelte.ts'
import type { Neuron } from '#figures/network/neurons.ts'
import { language } from '#words/language.svelte.ts'
import { m } from '#words/message.ts'
import type { ShownRow } from '../model/table.ts'

export const number = (value: number, digits = 2): string => formatNumber(value, language.locale, digits)

/** With its sign before it. */
export const signed = (value: number, digits: number): string =>
  `${value < 0 ? '' : '+'}${number(value, digits)}`

/** A neuron's short name: where it sits, if that tells it from its neighbours. */
export function shortName({ place, label }: Neuron, layer: readonly Neuron[]): string {
  const alone = place !== null && layer.filter((one) => one.place === place).length === 1
  return alone ? place : label
}

/** How far off, by level: "15 percent off"; with the squared error for experts. */
export function errorWords(loss: number, shares: boolean): string {
  if (shares) return m['training.entropy']({ value: number(loss, 3) })
  const off = m['training.percentOff']({ percent: number(percentOff(loss), 0) })
  return level.name === 'expert' ? `${off} (${m['training.squared']({ value: number(loss, 4) })})` : off
}

/** What a curve says to the ear. */
export function curveWords(curve: readonly CurvePoint[], shares: boolean): string {
  const [first, last] = [curve[0], curve.at(-1)]
  if (!first || !last) return m['training.noCurve']()
  const facts = {
    rounds: last.round,
    first: errorWords(first.practised, shares),
    last: errorWords(last.practised, shares),
  }
  return last.kept === null
    ? m['training.curve'](facts)
    : m['training.curveKept']({ ...facts, kept: errorWords(last.kept, shares) })
}

/** "example 7: left eye 40, right eye 90, left wheel 10, right wheel 60". */
export function rowName(row: ShownRow, { inputs, outputs }: Named): string {
  const said = (layer: readonly Neuron[], values: readonly (number | null)[]) =>
    layer.map(
      (neuron, k) => `${shortName(neuron, layer)} ${values[k] === null ? '–' : number(values[k] ?? 0, 0)}`,
    )
  const list = [...said(inputs, row.inputs), ...said(outputs, row.outputs)].join(', ')
  return m['training.rowName']({ row: row.number, list })
}

interface Named {
  readonly inputs: readonly Neuron[]
  readonly outputs: readonly Neuron[]
}

/** How a row came about. */
export const driveName = ({ by }: Drive): string => m[`training.by.${by}`]()
