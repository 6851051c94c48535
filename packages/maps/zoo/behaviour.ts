import { optimumOf, type QWorld } from '@botgarten/learning/q-learning'
import type { MapFile } from '../types.ts'
import { worldOf } from './task.ts'
import { offered, type Cage, type Offered, type Outcome, type Wish } from './types.ts'

/**
 * The outcome of the best behaviour by value iteration, at both offered discount factors. `tie`: several behaviours
 * are equally good, and come to different outcomes.
 */
export function provedOf(
  cage: Cage,
  map: Pick<MapFile, 'map'>,
  setting: number,
): { readonly [gamma in Offered]: Outcome | 'tie' } {
  const at = (gamma: Offered) => {
    const world = worldOf(cage, map, setting, offered[gamma])
    const moves = bestMoves(world, offered[gamma])
    const outcomes = new Set(policies(world, moves).map((policy) => outcomeOf(world, policy, cage.wish)))
    return outcomes.size > 1 ? 'tie' : outcomeOf(world, moves, cage.wish)
  }
  return { aLot: at('aLot'), aLittle: at('aLittle') }
}

/** Mended: the wish comes true with both. */
export const isMended = (cage: Cage, map: Pick<MapFile, 'map'>, setting: number): boolean =>
  Object.values(provedOf(cage, map, setting)).every((outcome) => outcome === 'wish')

/** By station the stations that a best move leads to: several where they are equally good. */
export type Moves = readonly (readonly number[])[]

/** Of all best behaviours. Zoos have no slippery roads. */
export const bestMoves = (world: QWorld, gamma: number): Moves =>
  optimumOf(world, gamma).best.map((actions) => actions.map((action) => world.meant[action]!))

/** All ways to choose one of the moves at each station that can be reached. */
function policies(world: QWorld, moves: Moves): readonly Moves[] {
  const reached = reachedFrom(world, moves)
  return moves.reduce<readonly Moves[]>(
    (before, list, station) =>
      list.length > 1 && reached.has(station)
        ? list.flatMap((to) => before.map((policy) => [...policy, [to]]))
        : before.map((policy) => [...policy, list]),
    [[]],
  )
}

/**
 * What all behaviours of these moves have in common, from the start on: `wish` where each of them does as is meant, `never`
 * where none ends at the goal, else `other`.
 */
export function outcomeOf(world: QWorld, moves: Moves, wish: Wish): Outcome {
  const reached = reachedFrom(world, moves)
  if (![...reached].some((state) => isEnd(world, state))) return 'never'
  if (longest(world, moves, world.start, new Set()) > (wish.moves ?? Infinity)) return 'other'
  const { passes = [] } = wish
  const around = passes.some((station) =>
    [...reachedFrom(world, moves, station)].some((state) => isEnd(world, state)),
  )
  return around || circles(world, moves) ? 'other' : 'wish'
}

const isEnd = ({ terminal, isGoal }: QWorld, state: number) => terminal[state] === 1 && isGoal[state] === 1

/** Stations that are come to from the start; `without`: one that may not be entered. */
function reachedFrom(world: QWorld, moves: Moves, without = -1): ReadonlySet<number> {
  const reached = new Set([world.start])
  for (const state of reached)
    if (world.terminal[state] === 0) for (const to of moves[state]!) if (to !== without) reached.add(to)
  return reached
}

const circles = (world: QWorld, moves: Moves) => longest(world, moves, world.start, new Set()) === Infinity

/** Moves of the longest walk from a station to an end; Infinity where one of them goes in a circle. */
function longest(world: QWorld, moves: Moves, state: number, before: ReadonlySet<number>): number {
  if (world.terminal[state] === 1) return 0
  if (before.has(state)) return Infinity
  const walked = new Set([...before, state])
  return 1 + Math.max(0, ...moves[state]!.map((to) => longest(world, moves, to, walked)))
}

/** Stations that are come to again and again, in the order of their numbers; none where every walk ends. */
export function circleOf(world: QWorld, moves: Moves): readonly number[] {
  const again = (state: number) => {
    const from = { ...world, start: state }
    return [...reachedFrom(from, moves)].some(
      (one) => world.terminal[one] === 0 && moves[one]!.includes(state),
    )
  }
  return [...reachedFrom(world, moves)].filter(again).toSorted((a, b) => a - b)
}

/** A walk: at each station the first of its moves. Ends at an end, or after so many moves. */
export function walkOf(world: QWorld, moves: Moves, most: number): readonly number[] {
  const walked = [world.start]
  while (walked.length <= most && world.terminal[walked.at(-1)!] === 0) {
    const [to] = moves[walked.at(-1)!]!
    if (to === undefined) break
    walked.push(to)
  }
  return walked
}
