import type { ItemText, Section } from '../schema/itemTypes.ts'
import type { Copies, Plan, PlanParts } from '../schema/planTypes.ts'

/** Parts of a plan before and after its steps, in the order in which they are written. */
const before = ['minute', 'goals', 'prepare', 'network', 'words', 'wrong', 'easier', 'harder'] as const
const after = ['check'] as const

/** @throws RangeError where there are more or fewer sections than a plan with these steps has */
export function planParts({ sections }: ItemText, { steps }: Plan): PlanParts<Section> {
  const count = before.length + steps.length + after.length
  if (sections.length !== count)
    throw new RangeError(`A plan of ${steps.length} steps has ${count} sections, not ${sections.length}.`)
  return {
    ...(Object.fromEntries(before.map((name, at) => [name, sections[at]!])) as {
      readonly [name in (typeof before)[number]]: Section
    }),
    steps: sections.slice(before.length, before.length + steps.length),
    check: sections.at(-1)!,
  }
}

/** Minutes from the lesson's start at which each step begins. */
export const beginningsOf = ({ steps }: Plan): readonly number[] =>
  steps.map((_, at) => steps.slice(0, at).reduce((sum, { minutes }) => sum + minutes, 0))

/** How often something is copied for a class. */
export function timesOf(copies: Copies, children: number): number {
  if (copies.for === 'teacher') return 1
  const share = { child: 1, pair: 2 }
  return Math.ceil(children / (typeof copies.for === 'number' ? copies.for : share[copies.for]))
}
