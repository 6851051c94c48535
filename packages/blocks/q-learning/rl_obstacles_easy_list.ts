import { part } from '../parts/python.ts'
import { barrier, learningProgram, obstacles } from '../parts/learning-examples.ts'
import { words } from '../parts/looks.ts'
import { give } from '../parts/next.ts'
import { plugged, rowCount, rowName } from '../parts/rows.ts'
import type { Definition } from '../types.ts'

const type = 'rl_obstacles_easy_list'

/** Roads that are closed, one a row. */
export const rl_obstacles_easy_list: Definition = {
  type,
  pack: 'learning',
  look: {
    category: 'q-learning',
    shape: 'value',
    output: 'ObstacleList',
    fields: [],
    inputs: [],
    items: { prefix: 'ADD', min: 0, max: 99 },
    mutation: { list_type: 'Obstacle' },
    faces: {
      by: { attribute: 'list_type' },
      of: {
        Obstacle: {
          output: 'ObstacleList',
          plug: 'round',
          tint: 'actuator',
          items: { accepts: ['Obstacle'], add: `block.${type}.add`, fresh: barrier(2, 3) },
        },
      },
    },
    rows: [],
  },
  words: words(type),
  acts: false,
  check(block) {
    for (let k = 0; k < rowCount(block); k++)
      if (!plugged(block, rowName(k))) return [{ problem: 'problem.emptyObstacle', stops: false }]
    return []
  },
  run: () => give(0),
  python: part,
  example: learningProgram(obstacles([[3, 2]])), // prettier-ignore
}
