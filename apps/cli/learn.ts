import {
  greedyPath,
  courseStream,
  createLearner,
  layOutWorld,
  learnedPath,
  learnWatching,
  type QLearner,
  type Settings,
} from '@botgarten/learning/q-learning'
import { qProof } from '@botgarten/learning/proof'
import type { Command } from './commands.ts'
import { CallError } from './errors.ts'
import { notLearnedIn, planIn, sentenceOf, settingsSaid } from './learn-report.ts'
import { algorithmOf, decayOf, limitsOf, rulesOf, seedOf, taskOf, taskOptions } from './learn-options.ts'
import { findMap } from './maps.ts'
import { writeNotebook } from './notebook.ts'
import { numberIn, options, refuseMore } from './options.ts'

const known = {
  ...taskOptions,
  alpha: { type: 'string' },
  gamma: { type: 'string' },
  nu: { type: 'string' },
  rho: { type: 'string' },
  'alpha-decay': { type: 'string' },
  'rho-decay': { type: 'string' },
  notebook: { type: 'string' },
  json: { type: 'boolean' },
} as const

type Values = ReturnType<typeof options<typeof known>>['values']

/** `botgarten learn q …`: a way on a map, learned by trying. */
export const q: Command = { options: known, execute: learnWay }

function learnWay(args: string[]): string {
  const { values, positionals } = options(args, known)
  refuseMore(positionals)
  if (values.map === undefined) throw new CallError('call.needsMap')
  const world = layOutWorld(taskOf(findMap(values.map), values))
  const seed = seedOf(values)
  // The same dice as in the lab: a row of its table can be learned again here.
  const begin = () => createLearner(world, settingsOf(values), courseStream(seed))
  const learner = begin()
  const { moves, episodes } = limitsOf(values)
  const firstShortestMove = learnWatching(learner, moves, episodes)
  const way = greedyPath(learner)
  if (values.notebook !== undefined)
    writeNotebook(values.notebook, qProof(begin(), learner.steps, bestAtStart(learner)))
  const plan = planIn(learner)
  const notLearned = notLearnedIn(learnedPath(learner), plan)
  const report = {
    bestWay: way.states,
    reason: way.reason,
    walked: way.states ?? ('walked' in way ? way.walked : []),
    ...{ learned: notLearned === null, notLearned },
    ...(plan && { plan: plan.said }),
    q: Object.fromEntries(world.names.map((name, move) => [name, learner.q[move]!])),
    moves: learner.steps,
    episodes: learner.episodes,
    firstShortestMove,
    seed,
    settings: settingsSaid(learner.settings),
  }
  return values.json ? JSON.stringify(report) : sentenceOf(report)
}

/** Of the actions at the start the one that is worth most. */
function bestAtStart({ world, q }: QLearner): number {
  const [from, end] = [world.first[world.start]!, world.first[world.start + 1]!]
  return q.indexOf(Math.max(...q.subarray(from, end)), from)
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
