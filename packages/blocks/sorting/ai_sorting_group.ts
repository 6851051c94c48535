import { readIn } from '../parts/python.ts'
import { whole } from '../python.ts'
import { field } from '../parts/fields.ts'
import { choice, rows, sensorPort, worded, words } from '../parts/looks.ts'
import { fail, give } from '../parts/next.ts'
import { sensorAtPort } from '../parts/sensors.ts'
import { colourReading, find, showGroup, start } from '../parts/sorting-examples.ts'
import { groupOf, readingAt } from '../parts/sorting.ts'
import type { Definition } from '../types.ts'

const type = 'ai_sorting_group'

/** The group that this reading is nearest to: AS NUMBER from 1, or AS NAME as the program calls it. */
export const ai_sorting_group: Definition = {
  type,
  pack: 'learning',
  look: {
    category: 'sorting',
    shape: 'value',
    output: 'Number',
    fields: [choice('AS', [worded('NUMBER', 'groupNumber'), worded('NAME', 'groupName')]), sensorPort('1')],
    inputs: [],
    faces: { by: { field: 'AS' }, of: { NUMBER: { output: 'Number' }, NAME: { output: 'String' } } },
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  check: sensorAtPort('colour', 'SENSORPORT'),
  run(block, _frame, context) {
    const memory = context.memory.sorting()
    const reading = readingAt(block, context)
    if (reading === null) return fail('nothingToRead')
    if (memory.centres.length === 0) return fail('noGroupsYet')
    const group = groupOf(memory, reading)
    return give(field(block, 'AS', 'NUMBER') === 'NAME' ? (memory.names[group] ?? `${group + 1}`) : group + 1)
  },
  python: (py) => {
    const group = py.call('group_of', readIn(py, 'colour', 'rgb').code, py.sorting('centres'))
    if (py.field('AS', 'NUMBER') !== 'NAME') return whole(group)
    return whole(py.call('name_of', group, py.sorting('names')))
  },
  example: [start, colourReading, find(1), showGroup],
}
