import { placeAt } from '../parts/python.ts'
import { number, show, text } from '../parts/examples.ts'
import { rows, value, words } from '../parts/looks.ts'
import { ask, done, fail } from '../parts/next.ts'
import { numberAt } from '../parts/numbers.ts'
import { colourReading, find, groupAs, start } from '../parts/sorting-examples.ts'
import { MOST_GROUPS } from '../parts/sorting.ts'
import { afterAsking } from '../parts/steps.ts'
import { textOf } from '../parts/texts.ts'
import type { Definition } from '../types.ts'

const type = 'ai_sorting_name'

/** Calls a group by a name, before or after it is found; the computer gives none. */
export const ai_sorting_name: Definition = {
  type,
  pack: 'learning',
  look: {
    category: 'sorting',
    shape: 'statement',
    fields: [],
    inputs: [value('GROUP', 'Number'), value('NAME', 'String')],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: afterAsking([ask('GROUP'), ask('NAME')], (frame, context) => {
    const memory = context.memory.sorting()
    const group = Math.round(numberAt(frame, 0))
    const most = memory.centres.length || MOST_GROUPS
    if (group < 1 || group > most) return fail('noSuchGroup', { group, most })
    memory.names[group - 1] = textOf(frame.got[1])
    return done
  }),
  python: (py) => py.line(`${py.sorting('names')}[${placeAt(py, 'GROUP')}] = ${py.value('NAME')}`),
  example: [
    start,
    colourReading,
    find(1),
    { type, values: { GROUP: number(1), NAME: text('A') } },
    show(groupAs('NAME')),
  ],
}
