import { whole } from '../python.ts'
import { same } from '../parts/same.ts'
import { someList } from '../parts/lists.ts'
import { number, show, start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { listInput, typedBy } from '../parts/kinds.ts'
import { costOf, listAt } from '../parts/lists.ts'
import { choice, rows, worded, words } from '../parts/looks.ts'
import { ask } from '../parts/next.ts'
import { afterAsking } from '../parts/steps.ts'
import type { Definition, Value } from '../types.ts'

const type = 'robLists_indexOf'

/** Place of the first or last (END) equal entry, counted from 0; −1 where there is none. */
export const robLists_indexOf: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'lists',
    shape: 'value',
    output: 'Number',
    fields: [choice('END', [worded('FIRST', 'firstPlace'), worded('LAST', 'lastPlace')])],
    inputs: [listInput('VALUE'), { name: 'FIND', kind: 'value', accepts: [] }],
    typed: typedBy({ input: 'VALUE', entry: true }, { inputs: { FIND: 'type' } }),
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: afterAsking([ask('VALUE'), ask('FIND')], (frame, _context, block) => {
    const list = listAt(frame, 0)
    const isIt = (entry: Value) => same(entry, frame.got[1])
    const place = field(block, 'END', 'FIRST') === 'LAST' ? list.findLastIndex(isIt) : list.findIndex(isIt)
    return { next: 'done', value: place, cost: costOf(list.length) }
  }),
  python: (py) => {
    const last = py.field('END', 'FIRST') === 'LAST'
    return whole(py.call(last ? 'last_place' : 'first_place', py.value('VALUE'), py.value('FIND')))
  },
  example: [start, show({ type, fields: { END: 'FIRST' }, values: { VALUE: someList, FIND: number(2) } })],
}
