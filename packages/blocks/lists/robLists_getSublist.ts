import { indexIn } from '../parts/python.ts'
import { whole } from '../python.ts'
import { someList } from '../parts/lists.ts'
import { number, show, start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { listInput, typedBy } from '../parts/kinds.ts'
import { costOf, listAt, placeIn, wheres } from '../parts/lists.ts'
import { rows, valueWhen, words } from '../parts/looks.ts'
import { ask, fail } from '../parts/next.ts'
import { numberAt } from '../parts/numbers.ts'
import type { Block, Definition, Next } from '../types.ts'

const type = 'robLists_getSublist'

const counts = (block: Block, name: string) => field(block, name, 'FROM_START').startsWith('FROM')

const questionsOf = (block: Block): readonly Next[] => [
  ask('LIST'),
  ...(counts(block, 'WHERE1') ? [ask('AT1')] : []),
  ...(counts(block, 'WHERE2') ? [ask('AT2')] : []),
]

/** A new list from WHERE1 (AT1) to WHERE2 (AT2), both included; counted from 0. What lies beyond the list is left out; empty where the end is before the start. */
export const robLists_getSublist: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'lists',
    shape: 'value',
    output: 'any',
    fields: [wheres('WHERE1', 'FIRST'), wheres('WHERE2', 'LAST')],
    inputs: [
      listInput('LIST'),
      valueWhen('AT1', { field: 'WHERE1', is: ['FROM_START', 'FROM_END'] }, 'Number'),
      valueWhen('AT2', { field: 'WHERE2', is: ['FROM_START', 'FROM_END'] }, 'Number'),
    ],
    typed: typedBy({ input: 'LIST' }, { output: 'type' }),
    mutation: {
      at1: { field: 'WHERE1', is: ['FROM_START', 'FROM_END'] },
      at2: { field: 'WHERE2', is: ['FROM_START', 'FROM_END'] },
    },
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run(block, frame) {
    const questions = questionsOf(block)
    const question = questions[frame.stage++]
    if (question) return question
    const entries = listAt(frame, 0)
    const asked = questions.length === 3 ? numberAt(frame, 2) : numberAt(frame, 1)
    const from = placeIn(entries, field(block, 'WHERE1', 'FROM_START'), numberAt(frame, 1))
    const to = placeIn(entries, field(block, 'WHERE2', 'FROM_START'), asked)
    if (from === null || to === null) return fail(entries.length === 0 ? 'emptyList' : 'noSuchEntry')
    return { next: 'done', value: entries.slice(from, to + 1), cost: costOf(entries.length) }
  },
  python: (py) =>
    whole(py.call('part_of', py.value('LIST'), indexIn(py, 'WHERE1', 'AT1'), indexIn(py, 'WHERE2', 'AT2'))),
  example: [
    start,
    show({
      type: 'robLists_length',
      values: {
        VALUE: {
          type,
          mutation: { attrs: { at1: 'true', at2: 'false' } },
          fields: { WHERE1: 'FROM_START', WHERE2: 'LAST' },
          values: { LIST: someList, AT1: number(1) },
        },
      },
    }),
  ],
}
