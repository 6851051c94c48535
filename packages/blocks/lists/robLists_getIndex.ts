import { indexIn } from '../parts/python.ts'
import { binds, whole } from '../python.ts'
import { someList } from '../parts/lists.ts'
import { number, show, start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { listInput, typedBy } from '../parts/kinds.ts'
import { listAt, placeIn, wheres } from '../parts/lists.ts'
import { choice, rows, valueWhen, worded, words } from '../parts/looks.ts'
import { ask, fail, give } from '../parts/next.ts'
import { numberAt } from '../parts/numbers.ts'
import type { Definition } from '../types.ts'

const type = 'robLists_getIndex'

const list = ask('VALUE')
const at = ask('AT')

/** MODE GET, GET_REMOVE (values) or REMOVE (a statement: mutation `statement`); AT counts from 0, from the end too (mutation `at`). Mutation `datatype` is what today's files say of the entry; the list decides. */
export const robLists_getIndex: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'lists',
    shape: 'value',
    output: 'any',
    fields: [
      choice('MODE', [worded('GET', 'get'), worded('GET_REMOVE', 'getRemove'), worded('REMOVE', 'remove')]),
      wheres('WHERE'),
    ],
    inputs: [
      listInput('VALUE'),
      valueWhen('AT', { field: 'WHERE', is: ['FROM_START', 'FROM_END'] }, 'Number'),
    ],
    also: { shape: 'statement', when: { field: 'MODE', is: ['REMOVE'] } },
    typed: typedBy({ input: 'VALUE', entry: true }, { output: 'type' }),
    mutation: {
      statement: { field: 'MODE', is: ['REMOVE'] },
      at: { field: 'WHERE', is: ['FROM_START', 'FROM_END'] },
    },
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run(block, frame) {
    const where = field(block, 'WHERE', 'FROM_START')
    const stage = frame.stage++
    if (stage === 0) return list
    if (stage === 1 && where.startsWith('FROM')) return at
    const entries = listAt(frame, 0)
    const place = placeIn(entries, where, numberAt(frame, 1))
    if (place === null || place >= entries.length)
      return fail(entries.length === 0 ? 'emptyList' : 'noSuchEntry')
    const entry = entries[place] ?? null
    if (field(block, 'MODE', 'GET') !== 'GET') entries.splice(place, 1)
    return give(entry)
  },
  python: (py) => {
    const list = py.value('VALUE', binds.whole)
    const place = indexIn(py, 'WHERE', 'AT')
    const mode = py.field('MODE', 'GET')
    if (mode === 'GET') return whole(`${list}[${place}]`)
    const taken = `${list}.pop(${place === '-1' ? '' : place})`
    return mode === 'REMOVE' ? py.line(taken) : whole(taken)
  },
  example: [
    start,
    show({
      type,
      mutation: { attrs: { statement: 'false', at: 'true' } },
      fields: { MODE: 'GET', WHERE: 'FROM_START' },
      values: { VALUE: someList, AT: number(0) },
    }),
  ],
}
