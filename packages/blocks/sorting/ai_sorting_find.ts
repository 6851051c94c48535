import { rows, value, words } from '../parts/looks.ts'
import { ask, done, fail } from '../parts/next.ts'
import { numberAt } from '../parts/numbers.ts'
import { colourReading, find, showGroup, start } from '../parts/sorting-examples.ts'
import { findGroups, MOST_GROUPS } from '../parts/sorting.ts'
import { afterAsking } from '../parts/steps.ts'
import type { Definition } from '../types.ts'

const type = 'ai_sorting_find'
const most = MOST_GROUPS

/** Sorts what was collected into groups: k-means. */
export const ai_sorting_find: Definition = {
  type,
  pack: 'learning',
  look: {
    category: 'sorting',
    shape: 'statement',
    fields: [],
    inputs: [value('GROUPS', 'Number')],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  run: afterAsking([ask('GROUPS')], (frame, context) => {
    const memory = context.memory.sorting()
    const groups = Math.round(numberAt(frame, 0))
    const { length: count } = memory.readings
    if (groups < 1 || groups > most) return fail('groupsFromTo', { groups, most })
    // Without any reading there are no groups; who asks for one is told.
    if (count > 0 && count < groups) return fail('fewReadings', { groups, count })
    if (count > 0) findGroups(memory, groups)
    return done
  }),
  python: (py) => {
    const found = py.call('find_groups', py.sorting('readings'), py.value('GROUPS'))
    py.line(`${py.sorting('centres')}[:] = ${found}`)
  },
  example: [start, colourReading, colourReading, find(2), showGroup],
}
