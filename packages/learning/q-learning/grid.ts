import type { Action, Outcome, QMap } from './types.ts'

/** Rewards and odds of a grid that its letters do not say. */
export interface GridOptions {
  /** Probability that an action leads where it is meant; the rest goes to its two sides in equal parts. Without: 1. */
  readonly surefooted?: number
  /** Paid for falling off the cliff, which leads back to the start. */
  readonly cliffReward?: number
}

export interface Grid {
  readonly map: QMap
  readonly start: number
  readonly goal: number
}

const directions = [
  { name: 'left', x: -1, y: 0 },
  { name: 'down', x: 0, y: 1 },
  { name: 'right', x: 1, y: 0 },
  { name: 'up', x: 0, y: -1 },
] as const

/**
 * A grid world, read by rows from the upper left: S start, G goal, F floor, H hole (an attempt ends), C cliff (back to
 * the start), W wall. Who walks against a wall or the border stays. The worlds of Gymnasium's toy_text: frozen_lake.py,
 * cliffwalking.py; its order of actions: left, down, right, up.
 * @throws RangeError for rows of unequal length, unknown letters, no start or goal
 */
export function gridMap(
  rows: readonly string[],
  { surefooted = 1, cliffReward = 0 }: GridOptions = {},
): Grid {
  const cells = refuseNonsense(rows)
  const width = rows[0]!.length
  const start = cells.indexOf('S')

  const target = (from: number, turn: number) => {
    const { x, y } = directions[(turn + 4) % 4]!
    const [column, row] = [(from % width) + x, Math.floor(from / width) + y]
    const inside = column >= 0 && column < width && row >= 0 && row < rows.length
    const to = inside ? row * width + column : from
    return cells[to] === 'W' ? from : to
  }
  const arrive = (to: number, probability: number): Outcome =>
    cells[to] === 'C' ? { probability, to: start, reward: cliffReward } : { probability, to }
  const action = (from: number, turn: number): Action => {
    const sides = (1 - surefooted) / 2
    const odds = [
      arrive(target(from, turn - 1), sides),
      arrive(target(from, turn), surefooted),
      arrive(target(from, turn + 1), sides),
    ]
    const outcomes = odds.filter(({ probability }) => probability > 0)
    return { to: target(from, turn), name: directions[turn]!.name, outcomes }
  }
  const isBody = (letter: string) => letter === 'W' || letter === 'H' || letter === 'G'
  return {
    map: {
      actions: cells.map((letter, from) =>
        isBody(letter) ? [] : directions.map((_, turn) => action(from, turn)),
      ),
      terminals: cells.flatMap((letter, index) => (letter === 'H' ? [index] : [])),
    },
    start,
    goal: cells.indexOf('G'),
  }
}

function refuseNonsense(rows: readonly string[]): readonly string[] {
  const cells = [...rows.join('')]
  const odd = cells.find((letter) => !'SGFHCW'.includes(letter))
  if (odd !== undefined) throw new RangeError(`A grid has no cell ${odd}: S G F H C W.`)
  if (rows.some(({ length }) => length !== rows[0]!.length))
    throw new RangeError('The rows of a grid are equally long.')
  for (const letter of 'SG')
    if (cells.filter((cell) => cell === letter).length !== 1)
      throw new RangeError(`A grid has one start S and one goal G.`)
  return cells
}
