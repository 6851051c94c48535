import type { Move, Task } from './types.ts'

/** More stations than any map has, and than a screen could show. */
const MOST_STATIONS = 10_000

/**
 * A task laid out for the learner. Moves of station s are `first[s]` to `first[s + 1] − 1`, by rising target; outcomes
 * of move m are `outcome[m]` to `outcome[m + 1] − 1`.
 */
export interface QWorld {
  readonly task: Task
  readonly stations: number
  readonly start: number
  readonly goal: number
  readonly first: Int32Array
  /** Names of the moves: `3-5`. */
  readonly names: readonly string[]
  readonly from: Int32Array
  /** Where each move is meant to lead. */
  readonly meant: Int32Array
  readonly outcome: Int32Array
  readonly to: Int32Array
  readonly reward: Float64Array
  /** By outcome: probabilities of this one and those before it. */
  readonly upTo: Float64Array
  readonly isSlippery: boolean
  /** 1 where an episode of the standard rules ends. */
  readonly terminal: Uint8Array
  /** Stations that are not the goal and have a way out. */
  readonly open: Int32Array
}

/** @throws RangeError that names what is wrong with the task */
export function layOutWorld(task: Task): QWorld {
  refuseNonsense(task)
  const { map, start, goal } = task
  const stations = map.moves.length
  const open = map.moves.map((moves, from) => openMoves(task, moves, from))
  const all = open.flatMap((moves, from) => moves.map((move) => ({ from, move, outcomes: outcomesOf(move) })))
  const outcomes = all.flatMap(({ move, outcomes: list }) => list.map((one) => ({ ...one, move })))
  const terminal = new Uint8Array(stations)
  for (const station of [goal, ...(map.terminals ?? [])]) terminal[station] = 1
  return {
    ...{ task, stations, start, goal, terminal },
    first: sumsOf(open.map(({ length }) => length)),
    names: all.map(({ from, move }) => `${from}-${move.name ?? move.to}`),
    from: Int32Array.from(all, ({ from }) => from),
    meant: Int32Array.from(all, ({ move }) => move.to),
    outcome: sumsOf(all.map(({ outcomes: { length } }) => length)),
    to: Int32Array.from(outcomes, ({ to }) => to),
    reward: Float64Array.from(outcomes, ({ move, to, reward = 0 }) => reward + payFor(task, move, to)),
    upTo: Float64Array.from(all.flatMap(({ outcomes: list }) => upTo(list))),
    isSlippery: all.some(({ outcomes: { length } }) => length > 1),
    open: Int32Array.from(
      open.flatMap(({ length }, station) => (length > 0 && station !== goal ? [station] : [])),
    ),
  }
}

function openMoves({ closed = [] }: Task, moves: readonly Move[], from: number): readonly Move[] {
  return moves
    .filter(({ to }) => !closed.some((road) => road[0] === from && road[1] === to))
    .toSorted((a, b) => (a.name || b.name ? 0 : a.to - b.to))
}

const outcomesOf = (move: Move) => move.outcomes ?? [{ probability: 1, to: move.to, reward: 0 }]

function payFor(task: Task, move: Move, to: number): number {
  const { map, goal, goalReward = 50, stepCost = 0, lengthCost = 0 } = task
  const arriving = (to === goal ? goalReward : 0) + (map.rewards?.[to] ?? 0)
  return arriving + (move.reward ?? 0) - stepCost - lengthCost * (move.length ?? 0)
}

function sumsOf(lengths: readonly number[]): Int32Array {
  const sums = new Int32Array(lengths.length + 1)
  lengths.forEach((length, index) => (sums[index + 1] = sums[index]! + length))
  return sums
}

function upTo(outcomes: readonly { readonly probability: number }[]): number[] {
  let sum = 0
  const sums = outcomes.map(({ probability }) => (sum += probability))
  // Thirds add up to a hair less than 1.
  sums[sums.length - 1] = 1
  return sums
}

function refuseNonsense(task: Task): void {
  const { map, start, goal } = task
  const count = map.moves.length
  if (count < 1 || count > MOST_STATIONS)
    throw new RangeError(`A map has 1 to ${MOST_STATIONS} stations, not ${count}.`)
  const station = (number: number, what: string) => {
    if (!Number.isInteger(number) || number < 0 || number >= count)
      throw new RangeError(`${what} is station ${number}; there are 0 to ${count - 1}.`)
  }
  station(start, 'The start')
  station(goal, 'The goal')
  for (const number of map.terminals ?? []) station(number, 'A terminal')
  for (const [number, reward] of Object.entries(map.rewards ?? {})) {
    station(Number(number), 'A reward')
    finite(reward, `The reward of station ${number}`)
  }
  for (const key of ['goalReward', 'stepCost', 'lengthCost'] as const) finite(task[key] ?? 0, key)
  map.moves.forEach((moves, from) => {
    for (const move of moves) {
      const name = `Road ${from}-${move.to}`
      for (const { to, reward = 0 } of [move, ...(move.outcomes ?? [])]) {
        station(to, `The end of ${name}`)
        finite(reward, `The reward of ${name}`)
      }
      if (!((move.length ?? 0) >= 0)) throw new RangeError(`${name} has the length ${move.length}.`)
      finite(move.length ?? 0, `The length of ${name}`)
      if (move.outcomes) refuseOdds(move.outcomes, name)
    }
  })
}

function refuseOdds(outcomes: readonly { readonly probability: number }[], name: string): void {
  const sum = outcomes.reduce((all, { probability }) => all + probability, 0)
  if (!(Math.abs(sum - 1) < 1e-9) || outcomes.some(({ probability }) => probability < 0))
    throw new RangeError(`The probabilities of ${name} add up to ${sum}, not to 1.`)
}

function finite(value: number, what: string): void {
  if (!Number.isFinite(value)) throw new RangeError(`${what} is ${value}, not a number that counts.`)
}
