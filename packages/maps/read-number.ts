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
