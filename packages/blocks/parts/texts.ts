import type { Value } from '../types.ts'
import { colours, isColour } from './colours.ts'

/** What a text neuron shows while it is not above 0. The screen says it in the child's language (`neuron.empty`). */
export const nothing = '∅'

/** At most four places after a decimal point, no zeros at the end, no minus before 0. */
const numberText = (x: number): string =>
  Number.isFinite(x) ? String(Number(x.toFixed(4)) + 0) : x > 0 ? '∞' : '-∞'

const colourText = (colour: string) =>
  colours.find(({ value }) => value === colour.toUpperCase())?.name ?? colour.toUpperCase()

/** A value as the robot's display shows it, equal in every language. */
export function textOf(value: Value | undefined): string {
  if (typeof value === 'number') return numberText(value)
  if (isColour(value)) return colourText(value)
  if (Array.isArray(value)) return `[${value.map((entry: Value) => textOf(entry)).join(', ')}]`
  return typeof value === 'string' || typeof value === 'boolean' ? String(value) : ''
}
