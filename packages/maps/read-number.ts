import type { Element } from './elements.ts'
import { numbersIn } from './path.ts'
import type { MapProblem } from './types.ts'

export const problem = (kind: MapProblem['kind'], facts: MapProblem['facts']): MapProblem => ({ kind, facts })

/** Nothing where nothing is said. */
export const keep = <Name extends string>(name: Name, value: number | undefined) =>
  (value === undefined ? {} : { [name]: value }) as { [key in Name]?: number }

export function numberIn(text: string | undefined, name: string, problems: MapProblem[]): number | undefined {
  if (text === undefined) return undefined
  const value = Number(text)
  if (text.trim() !== '' && Number.isFinite(value)) return value
  problems.push(problem('number', { name, value: text }))
  return undefined
}

/** Of a drawing: its view box, else its width and height. */
export function sizeOf({ attributes }: Pick<Element, 'attributes'>) {
  const [, , width, height] = numbersIn(attributes['viewBox'] ?? '') ?? []
  const length = (name: 'width' | 'height') => Number((attributes[name] ?? '').replace(/px$/, '')) || 0
  return { width: width ?? length('width'), height: height ?? length('height') }
}
