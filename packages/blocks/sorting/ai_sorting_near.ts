import { placeAt, readIn, beforeOf } from '../parts/python.ts'
import { whole } from '../python.ts'
import { number, show } from '../parts/examples.ts'
import { rows, sensorPort, value, words } from '../parts/looks.ts'
import { ask, fail, give } from '../parts/next.ts'
import { numberAt } from '../parts/numbers.ts'
import { sensorAtPort } from '../parts/sensors.ts'
import { colourReading, find, start } from '../parts/sorting-examples.ts'
import { distancesTo, readingAt } from '../parts/sorting.ts'
import { afterAsking } from '../parts/steps.ts'
import type { Definition } from '../types.ts'

const type = 'ai_sorting_near'

/** How far this reading is from a group's middle, in steps of red, green and blue (0 to 441). */
export const ai_sorting_near: Definition = {
  type,
  pack: 'learning',
  look: {
    category: 'sorting',
    shape: 'value',
    output: 'Number',
    fields: [sensorPort('1')],
    inputs: [value('GROUP', 'Number')],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  check: sensorAtPort('colour', 'SENSORPORT'),
  run: afterAsking([ask('GROUP')], (frame, context, block) => {
    const memory = context.memory.sorting()
    const reading = readingAt(block, context)
    const group = Math.round(numberAt(frame, 0))
    if (reading === null) return fail('nothingToRead')
    if (memory.centres.length === 0) return fail('noGroupsYet')
    const away = distancesTo(memory, reading)[group - 1]
    return away === undefined ? fail('noSuchGroup', { group, most: memory.centres.length }) : give(away)
  }),
  python: (py) =>
    whole(
      py.call(
        'distance_to',
        readIn(py, 'colour', 'rgb').code,
        `${py.sorting('centres')}[${beforeOf(placeAt(py, 'GROUP'))}]`,
      ),
    ),
  example: [
    start,
    colourReading,
    find(1),
    show({ type, fields: { SENSORPORT: '1' }, values: { GROUP: number(1) } }),
  ],
}
