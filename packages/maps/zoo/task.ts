import { layOutWorld, type Action, type QMap, type QWorld } from '@botgarten/learning/q-learning'
import type { MapFile } from '../types.ts'
import type { Cage, Mend, MendOption, Pay } from './types.ts'

/** Where the setting of a mend stands before anybody touches it: the reward of its rule, or the first option. */
export const untouched = ({ mend, pay }: Pick<Cage, 'mend' | 'pay'>): number =>
  'rule' in mend ? Math.abs(pay[mend.rule]!.reward) : 0

/** All settings that a mend has. */
export function settingsOf(mend: Mend): readonly number[] {
  if ('options' in mend) return mend.options.map((_, index) => index)
  const { least, most, step } = mend
  return Array.from({ length: Math.floor((most - least) / step) + 1 }, (_, index) => least + index * step)
}

/** What is paid at a setting of the mend. */
export function paidAt(
  { mend, pay, endless }: Pick<Cage, 'mend' | 'pay' | 'endless'>,
  setting: number,
): Omit<MendOption, 'id'> {
  if ('options' in mend) return mend.options[setting]!
  const reward = mend.costs && setting !== 0 ? -setting : setting
  const changed = pay.map((rule, index) => (index === mend.rule ? { ...rule, reward } : rule))
  return { pay: changed, ...(endless && { endless }) }
}

/** A cage as a world to learn in. `gamma` counts where closeness is paid exactly. */
export function worldOf(cage: Cage, { map }: Pick<MapFile, 'map'>, setting: number, gamma: number): QWorld {
  const { pay, endless } = paidAt(cage, setting)
  const distances = { goal: movesTo(map, cage.goal), of: (station: number) => movesFrom(map, station) }
  const goalReward = sumOf(pay.flatMap((rule) => (rule.for === 'goal' ? [rule.reward] : [])))
  const actions = map.actions.map((list, from) =>
    list.map((action) => ({
      ...action,
      reward: sumOf(pay.map((rule) => forMove(rule, from, action, distances, gamma))),
    })),
  )
  const { start, goal } = cage
  return layOutWorld({
    ...{ map: { ...map, actions, ...(endless && { endless }) }, start, goal },
    // A goal with no reward is still where the mission ends.
    goalReward,
  })
}

const sumOf = (reward: readonly number[]) => reward.reduce((sum, one) => sum + one, 0)

interface Distances {
  /** Moves from each station to the goal. */
  readonly goal: readonly number[]
  /** Moves to each station from one. */
  readonly of: (station: number) => readonly number[]
}

function forMove(rule: Pay, from: number, { to }: Action, distances: Distances, gamma: number): number {
  switch (rule.for) {
    case 'goal':
      return 0
    case 'move':
      return rule.reward
    case 'station':
      return rule.station === to ? rule.reward : 0
    case 'road':
      return isOn(rule, from, to) || (rule.both && isOn(rule, to, from)) ? rule.reward : 0
    case 'away': {
      const far = distances.of(rule.from)
      return far[to]! > far[from]! ? rule.reward : 0
    }
    case 'nearer':
      return forNearness(rule, distances.goal[from]!, distances.goal[to]!, gamma)
  }
}

const isOn = (rule: Extract<Pay, { for: 'road' }>, from: number, to: number) =>
  rule.from === from && rule.to === to

function forNearness(
  { reward, back }: Extract<Pay, { for: 'nearer' }>,
  before: number,
  after: number,
  gamma: number,
): number {
  if (back === 'exact') return reward * (before - gamma * after)
  return reward * (back === 'nothing' ? Math.max(0, before - after) : before - after)
}

/** Moves from a station to each; Infinity where no way leads. Breadth first. */
function movesFrom({ actions }: QMap, start: number): readonly number[] {
  const moves = actions.map(() => Infinity)
  moves[start] = 0
  const waiting = [start]
  for (const state of waiting)
    for (const { to } of actions[state]!) {
      if (moves[to] !== Infinity) continue
      moves[to] = moves[state]! + 1
      waiting.push(to)
    }
  return moves
}

const movesTo = (map: QMap, goal: number): readonly number[] => movesFrom({ actions: backwards(map) }, goal)

function backwards({ actions }: QMap): readonly (readonly Action[])[] {
  return actions.map((_, to) =>
    actions.flatMap((list, from) => (list.some((action) => action.to === to) ? [{ to: from }] : [])),
  )
}
