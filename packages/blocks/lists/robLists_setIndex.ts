import { indexIn } from '../parts/python.ts'
import { binds } from '../python.ts'
import { someList } from '../parts/lists.ts'
import { number, show } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { listInput, typedBy } from '../parts/kinds.ts'
import { costOf, listAt, mostEntries, placeIn, wheres } from '../parts/lists.ts'
import { choice, rows, valueWhen, worded, words } from '../parts/looks.ts'
import { ask, done, fail } from '../parts/next.ts'
import { numberAt } from '../parts/numbers.ts'
import { declared, variable } from '../parts/variables.ts'
import type { Definition, Next, Value } from '../types.ts'

const type = 'robLists_setIndex'

const list = ask('LIST')
const at = ask('AT')
const to = ask('TO')

function put(entries: Value[], mode: string, where: string, place: number, entry: Value): Next {
  if (mode === 'INSERT') {
    if (entries.length >= mostEntries) return fail('listTooLong', { most: mostEntries })
    const before = where === 'LAST' ? entries.length : place
    if (before > entries.length) return fail('noSuchEntry')
    entries.splice(before, 0, entry)
    return { next: 'done', cost: costOf(entries.length) }
  }
  if (place >= entries.length) return fail(entries.length === 0 ? 'emptyList' : 'noSuchEntry')
  entries[place] = entry
  return done
}

/** MODE SET puts TO in the place of an entry, INSERT before it (LAST: at the end). AT as in robLists_getIndex. The list itself changes. */
export const robLists_setIndex: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'lists',
    shape: 'statement',
    fields: [choice('MODE', [worded('SET', 'setEntry'), worded('INSERT', 'insert')]), wheres('WHERE')],
    inputs: [
      listInput('LIST'),
      valueWhen('AT', { field: 'WHERE', is: ['FROM_START', 'FROM_END'] }, 'Number'),
      { name: 'TO', kind: 'value', accepts: [] },
    ],
    typed: typedBy({ input: 'LIST', entry: true }, { inputs: { TO: 'type' } }),
    mutation: { at: { field: 'WHERE', is: ['FROM_START', 'FROM_END'] } },
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run(block, frame) {
    const where = field(block, 'WHERE', 'FROM_START')
    const counts = where.startsWith('FROM')
    const stage = frame.stage++
    if (stage === 0) return list
    if (stage === 1 && counts) return at
    if (stage === (counts ? 2 : 1)) return to
    const entries = listAt(frame, 0)
    const entry = frame.got[frame.got.length - 1] ?? null
    const place = placeIn(entries, where, numberAt(frame, 1))
    return place === null
      ? fail('noSuchEntry')
      : put(entries, field(block, 'MODE', 'SET'), where, place, entry)
  },
  python: (py) => {
    const list = py.value('LIST', binds.whole)
    const place = indexIn(py, 'WHERE', 'AT')
    const entry = py.value('TO')
    if (py.field('MODE', 'SET') === 'SET') py.line(`${list}[${place}] = ${entry}`)
    else
      py.line(
        py.field('WHERE') === 'LAST' ? `${list}.append(${entry})` : `${list}.insert(${place}, ${entry})`,
      )
  },
  example: [
    declared('xs', 'Array_Number', someList),
    {
      type,
      mutation: { attrs: { at: 'false' } },
      fields: { MODE: 'INSERT', WHERE: 'LAST' },
      values: { LIST: variable('xs', 'Array_Number'), TO: number(4) },
    },
    show({ type: 'robLists_length', values: { VALUE: variable('xs', 'Array_Number') } }),
  ],
}
