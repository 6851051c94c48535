import { part } from '../parts/python.ts'
import { learningProgram, obstacles } from '../parts/learning-examples.ts'
import { field } from '../parts/fields.ts'
import { hidden, rows, words } from '../parts/looks.ts'
import { mapChoice, stationsOf } from '../parts/maps.ts'
import { done } from '../parts/next.ts'
import type { Block, Definition, FieldLook } from '../types.ts'

const type = 'ai_q_learning_states_and_actions_map'

const station = (name: string, preset: number): FieldLook => ({
  ...{ name, kind: 'number', preset, min: 0, max: 499, step: 1 },
})

/** Which of its stations a map does not have. */
function missing(block: Block, count: number): readonly string[] {
  return ['START', 'FINISH'].filter((name) => !(Number(field(block, name, '0')) < count))
}

/**
 * The world in which the robot learns: a map, from where to where, and roads that are closed. Hidden: whether a move costs
 * its length (`TRUE`), what every move costs, and what stations and roads pay beside the goal (`3:10 2-5:-5`).
 */
export const ai_q_learning_states_and_actions_map: Definition = {
  type,
  pack: 'learning',
  look: {
    category: 'q-learning',
    shape: 'statement',
    icon: 'map',
    fields: [
      mapChoice('MAP_RAILWAY'),
      station('START', 0),
      station('FINISH', 1),
      hidden('LENGTH'),
      hidden('STEP_COST'),
      hidden('REWARDS'),
    ],
    inputs: [{ name: 'OBSTACLE', kind: 'value', accepts: ['ObstacleList'], optional: true }],
    rows: rows(type, 3),
  },
  words: words(type),
  acts: false,
  check(block, { maps }) {
    const count = stationsOf(field(block, 'MAP'), maps)
    const last = count - 1
    if (count === 0) return [{ problem: 'problem.noSuchMap', stops: true }]
    const [name] = missing(block, count)
    if (name) return [{ problem: 'problem.noSuchStation', facts: { last }, stops: true }]
    const same = Number(field(block, 'START', '0')) === Number(field(block, 'FINISH', '1'))
    return same ? [{ problem: 'problem.startIsGoal', stops: true }] : []
  },
  // What is to be learned is said to the playground; the run begins when it is learned.
  run: () => done,
  python: part,
  example: learningProgram(obstacles([[3, 2], [2, 3]])), // prettier-ignore
}
