import type { Topic } from '@botgarten/content/questionnaires'
import type { Band } from './atoms.ts'

/** A group of the study of 2020: means as they are printed, some of which are cut and not rounded. */
export interface StudyGroup {
  readonly band: Band
  /** Worked out from its percentages; its section 7.2 lists 9, 7 and 7. */
  readonly n: number
  readonly interest: { readonly [topic in Topic]: number }
  readonly ease: { readonly [topic in Topic]: number }
  /** Who would like to go on: shares of 1. */
  readonly goOn: { readonly yes: number; readonly maybe: number; readonly no: number }
}

/**
 * What children answered in August 2020 in Düsseldorf, 24 by its own count.
 * Source: the master's thesis that Botgarten comes from, sections 7.4.1 to 7.4.4 and figure 50.
 */
export const study2020: readonly StudyGroup[] = [
  {
    ...{ band: '3-4', n: 10 },
    interest: { supervised: 4.3, reinforcement: 4.4, unsupervised: 4 },
    ease: { supervised: 3.3, reinforcement: 4.2, unsupervised: 4.4 },
    goOn: { yes: 0.6, maybe: 0.4, no: 0 },
  },
  {
    ...{ band: '5-6', n: 7 },
    interest: { supervised: 4.57, reinforcement: 4.42, unsupervised: 4.14 },
    ease: { supervised: 4.28, reinforcement: 3.42, unsupervised: 4.14 },
    goOn: { yes: 0.714, maybe: 0.286, no: 0 },
  },
  {
    ...{ band: '7-9', n: 7 },
    interest: { supervised: 4, reinforcement: 4.14, unsupervised: 3.71 },
    ease: { supervised: 4, reinforcement: 4, unsupervised: 4.28 },
    goOn: { yes: 1, maybe: 0, no: 0 },
  },
]

/** The answers of all children to whether they would like more: shares of 1, counted from the groups; section 7.4.4 prints 75 and 25 %. */
export function goOn2020(): StudyGroup['goOn'] & { readonly n: number } {
  const n = study2020.reduce((sum, group) => sum + group.n, 0)
  const share = (answer: keyof StudyGroup['goOn']) =>
    study2020.reduce((sum, group) => sum + Math.round(group.n * group.goOn[answer]), 0) / n
  return { n, yes: share('yes'), maybe: share('maybe'), no: share('no') }
}
