import { decayOf as readDecay } from '@botgarten/experiments/sweep'
import type { Decay, Settings, Task } from '@botgarten/learning/q-learning'
import type { MapFile } from '@botgarten/maps'
import { CallError } from './errors.ts'
import { numberIn, oneOf, wholeNumberIn } from './options.ts'

/** What `learn q` and `learn q-sweep` both take to say what is to be learned. */
export const taskOptions = {
  map: { type: 'string' },
  start: { type: 'string' },
  goal: { type: 'string' },
  closed: { type: 'string' },
  'goal-reward': { type: 'string' },
  'step-cost': { type: 'string' },
  'length-cost': { type: 'string' },
  rules: { type: 'string' },
  algorithm: { type: 'string' },
  episodes: { type: 'string' },
  time: { type: 'string' },
  seed: { type: 'string' },
} as const

type Given = { readonly [name in keyof typeof taskOptions]?: string }

const most = 1e9
const huge = 1e12

/** The task: the map's own start, goal and rewards, unless the call sets others. */
export function taskOf(file: MapFile, given: Given): Task {
  const last = file.map.actions.length - 1
  const station = (name: 'start' | 'goal') => {
    const preset = file[name]
    if (given[name] === undefined && preset === undefined)
      throw new CallError('call.needsStation', { name, last })
    return wholeNumberIn(name, given[name], preset ?? 0, 0, last)
  }
  return {
    map: file.map,
    start: station('start'),
    goal: station('goal'),
    closed: closedIn(file, given.closed),
    goalReward: numberIn('goal-reward', given['goal-reward'], file.goalReward ?? 50, -huge, huge),
    stepCost: numberIn('step-cost', given['step-cost'], file.stepCost ?? 0, -huge, huge),
    lengthCost: numberIn('length-cost', given['length-cost'], file.lengthCost ?? 0, -huge, huge),
  }
}

function closedIn({ map }: MapFile, text: string | undefined): [number, number][] {
  if (text === undefined || text === '') return []
  return text.split(',').map((name) => {
    const [, from, to] = /^(\d+)-(\d+)$/.exec(name.trim())?.map(Number) ?? []
    if (from === undefined || to === undefined || !map.actions[from]?.some((road) => road.to === to))
      throw new CallError('call.closed', { name })
    return [from, to]
  })
}

/** How long: moves and episodes; whichever is done first ends it. */
export function limitsOf({ time, episodes }: Given): { readonly moves: number; readonly episodes: number } {
  const moves = wholeNumberIn('time', time, most, 1, most)
  const preset = time === undefined ? 1000 : most
  return { moves, episodes: wholeNumberIn('episodes', episodes, preset, 1, most) }
}

export const seedOf = ({ seed }: Pick<Given, 'seed'>) => wholeNumberIn('seed', seed, 1, 0, 4_294_967_295)

export const rulesOf = ({ rules }: Given): Settings['rules'] =>
  oneOf('rules', rules, ['standard', 'study'] as const)
export const algorithmOf = ({ algorithm }: Given): Settings['algorithm'] =>
  oneOf('algorithm', algorithm, ['q', 'sarsa'] as const)

/** As `decayOf` of the sweeps; visits are counted for α alone. */
export function decayOf(name: 'alpha-decay' | 'rho-decay', text: string | undefined): Decay {
  const visits = text === 'visits' && name === 'alpha-decay'
  if (text !== undefined && !visits) numberIn(name, text, 1, 0, 1)
  return readDecay(text)
}
