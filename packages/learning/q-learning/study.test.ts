import { stream } from '@botgarten/numbers'
import { isLong } from '@botgarten/numbers/testing'
import { describe, expect, test } from 'vitest'
import { greedyPath, createLearner, layOutWorld, run, step, type QMap, type Settings } from './index.ts'
import graphs from './reference/graphs.json' with { type: 'json' }
import study from './reference/study.json' with { type: 'json' }

type Name = keyof typeof graphs

/** Of a drawing's roads, both directions. */
function task(name: Name) {
  const { stations: states, edges, start, goal, closed } = graphs[name]
  const map: QMap = {
    actions: Array.from({ length: states }, (_, from) =>
      edges.filter((edge) => edge.includes(from)).map(([a, b]) => ({ to: a === from ? b! : a! })),
    ),
  }
  return { map, start, goal, closed: closed as [number, number][] }
}

const settings = ([alpha, gamma, nu, rho]: number[]): Settings => ({
  ...{ rules: 'study', algorithm: 'q', alpha: alpha!, gamma: gamma!, nu: nu!, rho: rho! },
})

describe('the study rules', () => {
  test.each(study.moves)('give the tables of Algorithm 1, move for move: $map $setting', (run) => {
    const learner = createLearner(layOutWorld(task(run.map as Name)), settings(run.setting), run.stream)
    for (const table of run.tables) {
      step(learner)
      expect([...learner.q]).toEqual(table)
    }
  })

  test.each(study.shares)('find a shortest way as often as Algorithm 1: $map $setting', (row) => {
    const name = row.map as Name
    const world = layOutWorld(task(name))
    const hits = study.after.map(() => 0)
    const runs = isLong ? row.runs : row.runs / 100
    for (let index = 0; index < runs; index++) {
      const learner = createLearner(
        world,
        settings(row.setting),
        stream(index, `learn/${row.setting.join()}/${index}`),
      )
      study.after.forEach((moves, column) => {
        run(learner, moves - learner.steps)
        if (greedyPath(learner).states?.length === graphs[name].shortest) hits[column]! += 1
      })
    }
    hits.forEach((ours, column) => {
      const theirs = row.shortest[column]!
      const together = (ours + theirs) / (runs + row.runs)
      const error = Math.sqrt(together * (1 - together) * (1 / runs + 1 / row.runs))
      expect(Math.abs(ours / runs - theirs / row.runs)).toBeLessThanOrEqual(4.5 * error)
    })
  })
})
