import type { Colour } from '@botgarten/simulation'
import type { FieldLook } from '../types.ts'
import { isColour } from './colours.ts'

type Option = Extract<FieldLook, { kind: 'choice' }>['options'][number]

/** The option that a file's text names. Open Roberta writes colours in either case. */
export const optionFor = <One extends Pick<Option, 'value'>>(
  options: readonly One[],
  text: string,
): One | undefined =>
  options.find(({ value }) => value === text) ??
  options.find(({ value }) => value.toUpperCase() === text.toUpperCase())

/** The option whose colour comes nearest to a colour that is none of them; undefined for what is no colour. */
export function nearestOption<One extends { readonly dot?: string }>(
  options: readonly One[],
  text: string,
): One | undefined {
  if (!isColour(text)) return undefined
  const dotted = options.filter(({ dot }) => dot !== undefined)
  const far = ({ dot }: One) => distance(channels(dot as Colour), channels(text))
  return dotted.toSorted((a, b) => far(a) - far(b))[0]
}

const channels = (colour: Colour) => [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16))
const distance = (a: readonly number[], b: readonly number[]) =>
  a.reduce((sum, part, at) => sum + Math.abs(part - b[at]!), 0)
