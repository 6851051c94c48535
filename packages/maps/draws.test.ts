import { content } from '@botgarten/content/files'
import { createLearner, layOutWorld, run, saveLearner } from '@botgarten/learning/q-learning'
import { stream } from '@botgarten/numbers'
import { expect, test } from 'vitest'
// As they were before maps could slip, have several goals, or go on behind them.
import draws from './reference/draws.json' with { type: 'json' }

const settings = { rules: 'standard', alpha: 0.5, gamma: 0.8, nu: 0.1, rho: 0.5 } as const

test.each(Object.entries(draws))('5,000 moves of %s draw what they always drew', (name, expected) => {
  const [id, algorithm] = name.split(' ') as [string, 'q' | 'sarsa']
  const { map, start = 0, goal = 5, goalReward, stepCost } = content.mapFile(id)!
  const world = layOutWorld({
    ...{ map, start, goal },
    ...(goalReward !== undefined && { goalReward }),
    ...(stepCost !== undefined && { stepCost }),
  })
  const learner = createLearner(world, { ...settings, algorithm }, stream(7, 'learn/draws'))
  run(learner, 5000)
  const { stream: words, episodes, goals, q } = saveLearner(learner)
  expect({ stream: words, episodes, goals, sum: q.reduce((a, b) => a + b, 0) }).toEqual(expected)
})
