import { whole } from '../python.ts'
import { someList } from '../parts/lists.ts'
import { show, start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { listKinds } from '../parts/kinds.ts'
import { costOf, listAt } from '../parts/lists.ts'
import { choice, rows, worded, words } from '../parts/looks.ts'
import { ask, fail } from '../parts/next.ts'
import { statistics } from '../parts/statistics.ts'
import { afterAsking } from '../parts/steps.ts'
import type { Definition } from '../types.ts'

const type = 'math_on_list'

const pythonNames: ReadonlyMap<string, string> = new Map([
  ['SUM', 'sum'],
  ['MIN', 'min'],
  ['MAX', 'max'],
  ['AVERAGE', 'mean'],
  ['MEDIAN', 'median'],
  ['STD_DEV', 'deviation'],
])

/** Mutation `op` as OP. An empty list has a sum and nothing else. RANDOM takes any list. */
export const math_on_list: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'math',
    shape: 'value',
    output: 'Number',
    fields: [
      choice('OP', [
        worded('SUM', 'sum'),
        worded('MIN', 'min'),
        worded('MAX', 'max'),
        worded('AVERAGE', 'average'),
        worded('MEDIAN', 'median'),
        worded('STD_DEV', 'deviation'),
        worded('RANDOM', 'randomEntry'),
      ]),
    ],
    inputs: [{ name: 'LIST', kind: 'value', accepts: listKinds }],
    mutation: { op: { field: 'OP' } },
    faces: {
      by: { field: 'OP' },
      of: {
        SUM: { output: 'Number' },
        MIN: { output: 'Number' },
        MAX: { output: 'Number' },
        AVERAGE: { output: 'Number' },
        MEDIAN: { output: 'Number' },
        STD_DEV: { output: 'Number' },
        RANDOM: { output: 'any' },
      },
    },
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: afterAsking([ask('LIST')], (frame, { memory }, block) => {
    const list = listAt(frame, 0)
    const operator = field(block, 'OP', 'SUM')
    if (list.length === 0 && operator !== 'SUM') return fail('emptyList')
    const cost = costOf(list.length)
    if (operator === 'RANDOM')
      return { next: 'done', value: list[Math.floor(memory.random() * list.length)] ?? null, cost }
    const operation = statistics.get(operator)
    if (operation === undefined) return fail('unknownChoice')
    const result = operation(list.map(Number))
    return Number.isFinite(result) ? { next: 'done', value: result + 0, cost } : fail('tooBigNumber')
  }),
  python: (py) => {
    const operator = py.field('OP', 'SUM')
    if (operator === 'RANDOM') return whole(`${py.from('random', 'choice')}(${py.value('LIST')})`)
    const name = pythonNames.get(operator) ?? py.gap('problem.unknownChoice')
    return whole(py.call(name, py.value('LIST')))
  },
  example: [
    start,
    show({ type, mutation: { attrs: { op: 'SUM' } }, fields: { OP: 'SUM' }, values: { LIST: someList } }),
  ],
}
