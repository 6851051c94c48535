import { courseOf, type MapFile } from '@botgarten/maps'
import { learnedPath, run, shortestPath } from '@botgarten/learning/q-learning'
import type { LearningOutline } from '@botgarten/programs'

/** A row of the table of an answer: what a learner has after so many tries. */
export interface TriesRow {
  readonly tries: number
  /** Seconds that the dice of seed 1 take, a move a second. */
  readonly seconds: number
  /** The fewest and the most that the dice of seeds 1 to 5 take. */
  readonly range: readonly [number, number]
  /** The way of seed 1; null: there is none yet. */
  readonly way: readonly number[] | null
  /** How many of 100 learners (seeds 1 to 100) know a shortest way. */
  readonly shortest: number
}

const dice = 5
const bos = 100
/** No way is so long: only the number of tries ends a learning. */
const steps = 10_000_000

/** What the learner of a card comes to, by the number of its tries. Seeds are those of the lab and of `botgarten learn q`. */
export function triesOf(
  outline: LearningOutline,
  map: MapFile,
  tries: readonly number[],
): readonly TriesRow[] {
  return tries.map((episodes) => {
    const learned = Array.from({ length: bos }, (_, at) => learn(outline, map, at + 1, episodes))
    const some = learned.slice(0, dice).map(({ seconds }) => seconds)
    return {
      tries: episodes,
      seconds: learned[0]!.seconds,
      range: [Math.min(...some), Math.max(...some)],
      way: learned[0]!.way,
      shortest: learned.filter(({ isShortest }) => isShortest).length,
    }
  })
}

function learn(outline: LearningOutline, map: MapFile, seed: number, episodes: number) {
  const { learner } = courseOf(outline, map, seed)
  run(learner, steps, episodes)
  const way = learnedPath(learner).states
  return {
    ...{ way, seconds: learner.steps },
    isShortest: way?.length === shortestPath(learner.world),
  }
}

/** All ways with the fewest sections, stations in order. */
export function shortestWays(outline: LearningOutline, { map }: MapFile): readonly (readonly number[])[] {
  const { start, goal, closed } = outline
  const isOpen = (from: number, to: number) => closed.every(([a, b]) => a !== from || b !== to)
  let ways: (readonly number[])[] = [[start]]
  for (let sections = 1; sections < map.actions.length; sections++) {
    ways = ways.flatMap((way) => {
      const from = way.at(-1)!
      const next = map.actions[from]!.map(({ to }) => to)
      return next.filter((to) => isOpen(from, to) && !way.includes(to)).map((to) => [...way, to])
    })
    const arrived = ways.filter((way) => way.at(-1) === goal)
    if (arrived.length > 0) return arrived
  }
  return []
}

export type SettingName = 'alpha' | 'gamma' | 'nu' | 'rho'

export const settingsOf = ({ settings: { alpha, gamma, nu, rho } }: LearningOutline) => ({
  alpha,
  gamma,
  nu,
  rho,
})

/** What a learner knows after few tries where one setting differs from that of run 1. */
export interface ChangedRow {
  readonly name: SettingName
  readonly value: number
  /** How many of 100 learners know a shortest way. */
  readonly shortest: number
}

/** Settings as blocks offer them. */
const offered: { readonly [name in SettingName]: readonly number[] } = {
  alpha: [0.1, 0.9],
  gamma: [0.2],
  nu: [0.9],
  rho: [0.9, 0.1],
}

/** After so many tries, with one setting after the other as a block offers it and the others as in run 1. */
export const changedOf = (outline: LearningOutline, map: MapFile, tries: number): readonly ChangedRow[] =>
  (Object.keys(offered) as SettingName[]).flatMap((name) =>
    offered[name].map((value) => {
      const changed = { ...outline, settings: { ...outline.settings, [name]: value } }
      return { name, value, shortest: triesOf(changed, map, [tries])[0]!.shortest }
    }),
  )
