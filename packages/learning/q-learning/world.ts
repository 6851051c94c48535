import type { Action, Task } from './types.ts'

/** More states than any map has, and than a screen could show. */
const MOST_STATIONS = 10_000

/**
 * A task laid out for the learner. Moves of state s are `first[s]` to `first[s + 1] − 1`, by rising target; outcomes
 * of action m are `outcome[m]` to `outcome[m + 1] − 1`.
 */
export interface QWorld {
  readonly task: Task
  readonly states: number
  readonly start: number
  readonly goal: number
  readonly first: Int32Array
  /** Names of the actions: `3-5`. */
  readonly names: readonly string[]
  readonly from: Int32Array
  /** Where each action is meant to lead. */
  readonly meant: Int32Array
  /** Where each action leads: for sure, or else where it is meant to. Off a cliff it leads back. */
  readonly leads: Int32Array
  readonly outcome: Int32Array
  readonly to: Int32Array
  readonly reward: Float64Array
  /** By outcome: probabilities of this one and those before it. */
  readonly upTo: Float64Array
  readonly isSlippery: boolean
  /** By outcome: 1 where it is a fall, off a cliff or into an end that is no goal. */
  readonly isFall: Uint8Array
  /** 1 where an episode of the standard rules ends. */
  readonly terminal: Uint8Array
  /** 1 where the goal is, and at every state that counts as one. */
  readonly isGoal: Uint8Array
  /** States that are no goal and have a way out. */
  readonly open: Int32Array
}

/** @throws RangeError that names what is wrong with the task */
export function layOutWorld(task: Task): QWorld {
  refuseNonsense(task)
  const { map, start, goal } = task
  const states = map.actions.length
  const open = map.actions.map((actions, from) => openActions(task, actions, from))
  const all = open.flatMap((actions, from) =>
    actions.map((action) => ({ from, action, outcomes: outcomesOf(action, actions) })),
  )
  const outcomes = all.flatMap(({ outcomes: list }) => list)
  const isGoal = marksOf(states, [goal, ...(map.goals ?? [])])
  const terminals = new Set(map.terminals)
  const ends = [...(map.endless ? [] : [goal, ...(map.goals ?? [])]), ...(map.terminals ?? [])]
  return {
    ...{ task, states, start, goal, isGoal, terminal: marksOf(states, ends) },
    first: sumsOf(open.map(({ length }) => length)),
    names: all.map(({ from, action }) => `${from}-${action.name ?? action.to}`),
    from: Int32Array.from(all, ({ from }) => from),
    meant: Int32Array.from(all, ({ action }) => action.to),
    leads: Int32Array.from(all, ({ action, outcomes: list }) =>
      list.length === 1 ? list[0]!.to : action.to,
    ),
    outcome: sumsOf(all.map(({ outcomes: { length } }) => length)),
    to: Int32Array.from(outcomes, ({ to }) => to),
    reward: Float64Array.from(
      outcomes,
      ({ action, to, reward }) => reward + payFor(task, action, to, isGoal),
    ),
    upTo: Float64Array.from(all.flatMap(({ outcomes: list }) => upTo(list))),
    isFall: Uint8Array.from(outcomes, ({ to, falls }) =>
      falls || (terminals.has(to) && isGoal[to] === 0) ? 1 : 0,
    ),
    isSlippery: all.some(({ outcomes: { length } }) => length > 1),
    open: Int32Array.from(
      open.flatMap(({ length }, state) => (length > 0 && isGoal[state] === 0 ? [state] : [])),
    ),
  }
}

function openActions({ closed = [] }: Task, actions: readonly Action[], from: number): readonly Action[] {
  return actions
    .filter(({ to }) => !closed.some((road) => road[0] === from && road[1] === to))
    .toSorted((a, b) => (a.name || b.name ? 0 : a.to - b.to))
}

/** An outcome, and the action whose road is really taken. */
interface Taken {
  readonly probability: number
  readonly to: number
  readonly reward: number
  readonly falls?: boolean
  readonly action: Action
}

function outcomesOf(action: Action, open: readonly Action[]): readonly Taken[] {
  if (action.outcomes) return action.outcomes.map((one) => ({ reward: 0, ...one, action }))
  const meant = { probability: 1, to: action.to, reward: 0, action }
  const others = open.filter((other) => other !== action)
  const { slip = 0 } = action
  if (slip === 0 || others.length === 0) return [meant]
  const aside = others.map((other) => ({
    ...{ probability: slip / others.length, to: other.to, reward: 0, action: other },
  }))
  return [{ ...meant, probability: 1 - slip }, ...aside]
}

function marksOf(states: number, marked: readonly number[]): Uint8Array {
  const marks = new Uint8Array(states)
  for (const state of marked) marks[state] = 1
  return marks
}

function payFor(task: Task, action: Action, to: number, isGoal: Uint8Array): number {
  const { map, goalReward = 50, stepCost = 0, lengthCost = 0 } = task
  const arriving = (isGoal[to] === 1 ? goalReward : 0) + (map.rewards?.[to] ?? 0)
  return arriving + (action.reward ?? 0) - stepCost - lengthCost * (action.length ?? 0)
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
  const count = map.actions.length
  if (count < 1 || count > MOST_STATIONS)
    throw new RangeError(`A map has 1 to ${MOST_STATIONS} stations, not ${count}.`)
  const station = (number: number, what: string) => {
    if (!Number.isInteger(number) || number < 0 || number >= count)
      throw new RangeError(`${what} is station ${number}; there are 0 to ${count - 1}.`)
  }
  station(start, 'The start')
  station(goal, 'The goal')
  for (const number of map.terminals ?? []) station(number, 'A terminal')
  for (const number of map.goals ?? []) station(number, 'A goal')
  for (const [number, reward] of Object.entries(map.rewards ?? {})) {
    station(Number(number), 'A reward')
    finite(reward, `The reward of station ${number}`)
  }
  for (const key of ['goalReward', 'stepCost', 'lengthCost'] as const) finite(task[key] ?? 0, key)
  map.actions.forEach((actions, from) => {
    for (const action of actions) {
      const name = `Road ${from}-${action.to}`
      for (const { to, reward = 0 } of [action, ...(action.outcomes ?? [])]) {
        station(to, `The end of ${name}`)
        finite(reward, `The reward of ${name}`)
      }
      if (!((action.length ?? 0) >= 0)) throw new RangeError(`${name} has the length ${action.length}.`)
      finite(action.length ?? 0, `The length of ${name}`)
      const { slip = 0 } = action
      if (!(slip >= 0 && slip <= 1)) throw new RangeError(`${name} slips with probability ${slip}.`)
      if (action.outcomes) refuseOdds(action.outcomes, name)
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
