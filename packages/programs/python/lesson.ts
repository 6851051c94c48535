import { learningIn } from '../learning.ts'
import type { Draft } from './draft.ts'
import type { Lesson } from './types.ts'
import type { Usage } from './usage.ts'

/** What the robot goes on learning from; undefined where it is not to learn, or cannot. */
export const lessonIn = ({ input }: Draft): Lesson | undefined =>
  input.learner === true ? input.learned?.lesson : undefined

/** Numbers of the learner at the head of a file. */
const constants = {
  table: 'Q_TABLE',
  roads: 'ROADS',
  rewards: 'REWARDS',
  start: 'START',
  ends: 'ENDS',
  open: 'STATIONS',
  alpha: 'LEARNING_RATE',
  gamma: 'DISCOUNT',
  rho: 'EXPLORING',
  nu: 'ELSEWHERE',
} as const

/** How a file calls one of them. */
export const constantOf = ({ names }: Draft, what: keyof typeof constants): string =>
  names.of(`learner ${what}`, constants[what])

const rounded = (number: number) => String(Number(number.toFixed(2)) + 0)
const dict = (pairs: readonly (readonly [string | number, string])[]) =>
  `{${pairs.map(([key, code]) => `${key}: ${code}`).join(', ')}}`

/** Roads, rewards and settings of a robot that learns on a floor. */
export function lessonLines(draft: Draft, { program }: Usage): void {
  const lesson = lessonIn(draft)
  if (!lesson) return
  const blocks = Object.values(learningIn(program)?.blocks ?? {})
  const line = (code: string) => draft.constants.push({ code, depth: 0, blocks })
  const constant = (what: keyof typeof constants, code: string) =>
    line(`${constantOf(draft, what)} = ${code}`)
  const { start, ends, open, settings } = lesson
  line(`# ${draft.say('python.learner.roads')}`)
  constant('roads', roadsOf(lesson))
  constant('rewards', rewardsOf(lesson))
  constant('start', String(start))
  constant('ends', `[${ends.join(', ')}]`)
  constant('open', `[${open.join(', ')}]`)
  line(`# ${draft.say('python.learner.settings')}`)
  for (const what of ['alpha', 'gamma', 'rho', 'nu'] as const) constant(what, String(settings[what]))
}

const roadsOf = ({ roads }: Lesson): string =>
  dict(
    Object.entries(roads).map(([from, targets]) => {
      const legs = Object.entries(targets).map(
        ([to, { direction, length }]) => [to, `(${rounded(direction)}, ${rounded(length)})`] as const,
      )
      return [from, dict(legs)] as const
    }),
  )

const rewardsOf = ({ roads }: Lesson): string =>
  dict(
    Object.entries(roads).flatMap(([from, targets]) =>
      Object.entries(targets).flatMap(([to, { reward }]) =>
        reward === 0 ? [] : [[`(${from}, ${to})`, String(reward)] as const],
      ),
    ),
  )

/** A table in which nothing is learned yet. */
export const emptyTable = ({
  roads,
}: Lesson): { readonly [from: string]: { readonly [to: string]: number } } =>
  Object.fromEntries(
    Object.entries(roads).map(([from, targets]) => [
      from,
      Object.fromEntries(Object.keys(targets).map((to) => [to, 0])),
    ]),
  )
