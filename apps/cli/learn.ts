import {
  bestWay,
  courseStream,
  createLearner,
  layOutWorld,
  learnedWay,
  learnWatching,
  type Settings,
} from '@botgarten/learning/q-learning'
import { CallError, numberIn, options } from './errors.ts'
import { kMeans } from './kmeans.ts'
import { notLearnedIn, planIn, sentenceOf, settingsSaid } from './learn-report.ts'
import { algorithmOf, decayOf, limitsOf, rulesOf, seedOf, taskOf, taskOptions } from './learn-options.ts'
import { findMap } from './maps.ts'
import { sweep } from './sweep/sweep.ts'
import { thesis } from './sweep/thesis.ts'

const known = {
  ...taskOptions,
  alpha: { type: 'string' },
  gamma: { type: 'string' },
  nu: { type: 'string' },
  rho: { type: 'string' },
  'alpha-decay': { type: 'string' },
  'rho-decay': { type: 'string' },
  json: { type: 'boolean' },
} as const

type Values = ReturnType<typeof options<typeof known>>['values']

const methods: { readonly [name: string]: (args: string[]) => string | Promise<string> } = {
  q,
  'q-sweep': sweep,
  'q-thesis': thesis,
  kmeans: kMeans,
}

/** `botgarten learn METHOD …`: learning without a screen. */
export function learn([method = '', ...args]: string[]): string | Promise<string> {
  const carryOut = Object.hasOwn(methods, method) ? methods[method] : undefined
  if (!carryOut) throw new CallError(`"learn" takes one of: ${Object.keys(methods).join(', ')}.`)
  return carryOut(args)
}

function q(args: string[]): string {
  const { values, positionals } = options(args, known)
  if (positionals.length > 0)
    throw new CallError(`"learn q" does not know what to do with "${positionals[0]}".`)
  if (values.map === undefined) throw new CallError('--map is needed: a map by its name, or an SVG file.')
  const world = layOutWorld(taskOf(findMap(values.map), values))
  const seed = seedOf(values)
  // The same dice as in the lab: a row of its table can be learned again here.
  const learner = createLearner(world, settingsOf(values), courseStream(seed))
  const { moves, episodes } = limitsOf(values)
  const firstShortestMove = learnWatching(learner, moves, episodes)
  const way = bestWay(learner)
  const plan = planIn(learner)
  const notLearned = notLearnedIn(learnedWay(learner), plan)
  const report = {
    bestWay: way.stations,
    reason: way.reason,
    walked: way.stations ?? ('walked' in way ? way.walked : []),
    ...{ learned: notLearned === null, notLearned },
    ...(plan && { plan: plan.said }),
    q: Object.fromEntries(world.names.map((name, move) => [name, learner.q[move]!])),
    moves: learner.moves,
    episodes: learner.episodes,
    firstShortestMove,
    seed,
    settings: settingsSaid(learner.settings),
  }
  return values.json ? JSON.stringify(report) : sentenceOf(report)
}

function settingsOf(values: Values): Settings {
  const share = (name: 'alpha' | 'gamma' | 'nu' | 'rho', preset: number) =>
    numberIn(name, values[name], preset, 0, 1)
  return {
    ...{ rules: rulesOf(values), algorithm: algorithmOf(values) },
    ...{
      alpha: share('alpha', 0.5),
      gamma: share('gamma', 0.8),
      nu: share('nu', 0.1),
      rho: share('rho', 0.5),
    },
    alphaDecay: decayOf('alpha-decay', values['alpha-decay']),
    rhoDecay: decayOf('rho-decay', values['rho-decay']),
  }
}
