import type { Action, Outcome, QMap } from './types.ts'

/** Rewards and odds of a grid that its letters do not say. */
export interface GridOptions {
  /** Probability that an action leads where it is meant; the rest goes to its two sides in equal parts. Without: 1. */
  readonly surefooted?: number
  /** Paid for falling off the cliff, which leads back to the start. */
  readonly cliffReward?: number
  /** By column, how many rooms the wind pushes a robot upwards that leaves a room of it. */
  readonly wind?: readonly number[]
  /** By goal, in the order of the rooms, with which probability it pays. Without: each time. */
  readonly chances?: readonly number[]
  /** What the task pays at a goal, where chances are given. Without: 50. */
  readonly goalReward?: number
}

export interface Grid {
  readonly map: QMap
  readonly start: number
  readonly goal: number
  /** Columns and rows of rooms. Where something is carried, a second floor of rooms follows the first. */
  readonly columns: number
  readonly rows: number
}

const directions = [
  { name: 'left', x: -1, y: 0 },
  { name: 'down', x: 0, y: 1 },
  { name: 'right', x: 1, y: 0 },
  { name: 'up', x: 0, y: -1 },
] as const

/** Probability that a step off the ice leads where it is meant. */
const ICE = 1 / 3

/**
 * A grid world, read by rows from the upper left: S start, G goal (each of several), F floor, H hole (an attempt ends),
 * C cliff (back to the start), W wall, P a parcel: a robot that enters carries it from then on, in states of their own behind
 * the others, and the goal is one for carriers alone; I ice: who leaves it gets where it is meant by 1/3, as in frozen_lake.py. Who walks against a wall or the border stays. The worlds of
 * Gymnasium's toy_text: frozen_lake.py, cliffwalking.py; its order of actions: left, down, right, up. Wind: Sutton &
 * Barto, 2nd edition, example 6.5. A single row has no up and down.
 * @throws RangeError for rows of unequal length, unknown letters, no start or goal, a wind that is no whole number
 */
export function gridMap(rows: readonly string[], options: GridOptions = {}): Grid {
  const cells = refuseNonsense(rows, options)
  const { surefooted = 1, cliffReward = 0, wind = [], chances = [], goalReward = 50 } = options
  const width = rows[0]!.length
  const count = cells.length
  const start = cells.indexOf('S')
  const floors = cells.includes('P') ? [0, count] : [0]
  const goals = cells.flatMap((letter, room) => (letter === 'G' ? [room + floors.at(-1)!] : []))
  const turns = rows.length === 1 ? [0, 2] : [0, 1, 2, 3]

  const next = (from: number, { x, y }: { readonly x: number; readonly y: number }) => {
    const [column, row] = [(from % width) + x, Math.floor(from / width) + y]
    const inside = column >= 0 && column < width && row >= 0 && row < rows.length
    const to = inside ? row * width + column : from
    return cells[to] === 'W' ? from : to
  }
  const target = (from: number, turn: number) => {
    let to = next(from, directions[(turn + 4) % 4]!)
    for (let push = wind[from % width] ?? 0; push > 0; push--) to = next(to, directions[3])
    return to
  }
  const arrive = (room: number, probability: number, floor: number): readonly Outcome[] => {
    if (cells[room] === 'C') return [{ probability, to: start + floor, reward: cliffReward, falls: true }]
    const to = room + (cells[room] === 'P' ? floors.at(-1)! : floor)
    const chance = chances[goals.indexOf(to)] ?? 1
    return [
      { probability: probability * chance, to },
      { probability: probability * (1 - chance), to, reward: -goalReward },
    ]
  }
  const action = (from: number, turn: number, floor: number): Action => {
    const firm = cells[from] === 'I' ? ICE : surefooted
    const sides = (1 - firm) / 2
    const odds = [
      ...arrive(target(from, turn - 1), sides, floor),
      ...arrive(target(from, turn), firm, floor),
      ...arrive(target(from, turn + 1), sides, floor),
    ]
    const outcomes = odds.filter(({ probability }) => probability > 0)
    const meant = target(from, turn)
    const lifts = cells[meant] === 'P' ? floors.at(-1)! : floor
    return { to: meant + lifts, name: directions[turn]!.name, outcomes }
  }
  const isBody = (letter: string, floor: number) =>
    letter === 'W' || letter === 'H' || (letter === 'G' && floor === floors.at(-1))
  return {
    map: {
      actions: floors.flatMap((floor) =>
        cells.map((letter, from) =>
          isBody(letter, floor) ? [] : turns.map((turn) => action(from, turn, floor)),
        ),
      ),
      terminals: floors.flatMap((floor) =>
        cells.flatMap((letter, room) => (letter === 'H' ? [room + floor] : [])),
      ),
      ...(goals.length > 1 && { goals: goals.slice(1) }),
    },
    ...{ start, goal: goals[0]!, columns: width, rows: rows.length },
  }
}

function refuseNonsense(
  rows: readonly string[],
  { wind = [], chances = [] }: GridOptions,
): readonly string[] {
  const cells = [...rows.join('')]
  const odd = cells.find((letter) => !'SGFHCWPI'.includes(letter))
  if (odd !== undefined) throw new RangeError(`A grid has no cell ${odd}: S G F H C W P I.`)
  if (rows.some(({ length }) => length !== rows[0]!.length))
    throw new RangeError('The rows of a grid are equally long.')
  const count = (letter: string) => cells.filter((cell) => cell === letter).length
  if (count('S') !== 1 || count('G') === 0)
    throw new RangeError('A grid has one start S and one goal G or more.')
  if (count('P') > 1) throw new RangeError('A grid has one parcel P at most.')
  if (wind.some((push) => !Number.isInteger(push) || push < 0))
    throw new RangeError('The wind of a column is a whole number.')
  if (chances.some((chance) => !(chance >= 0 && chance <= 1)))
    throw new RangeError('A chance is a number from 0 to 1.')
  return cells
}
