import { readIn } from '../parts/python.ts'
import { colourReading, find, showGroup, start } from '../parts/sorting-examples.ts'
import { rows, sensorPort, words } from '../parts/looks.ts'
import { done, fail } from '../parts/next.ts'
import { sensorAtPort } from '../parts/sensors.ts'
import { collect, readingAt } from '../parts/sorting.ts'
import type { Definition } from '../types.ts'

const type = 'ai_sorting_collect'

/** Keeps what the colour sensor reads now. */
export const ai_sorting_collect: Definition = {
  type,
  pack: 'learning',
  look: {
    category: 'sorting',
    shape: 'statement',
    fields: [sensorPort('1')],
    inputs: [],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  check: sensorAtPort('colour', 'SENSORPORT'),
  run(block, _frame, context) {
    const reading = readingAt(block, context)
    if (reading === null) return fail('nothingToRead')
    collect(context.memory.sorting(), reading)
    return done
  },
  python: (py) => py.line(`${py.sorting('readings')}.append(${readIn(py, 'colour', 'rgb').code})`),
  example: [start, colourReading, find(1), showGroup],
}
