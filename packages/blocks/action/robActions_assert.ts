import { number, show, start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { rows, value, words } from '../parts/looks.ts'
import { ask, done } from '../parts/next.ts'
import { textOf } from '../parts/texts.ts'
import type { Definition, Value } from '../types.ts'

const type = 'robActions_assert'

const out = ask('OUT')

/** Numbers with all their places, since they may differ in the last. */
const exactText = (value: Value) => (typeof value === 'number' ? String(value) : textOf(value))

/** Notes whether OUT is true. Of a comparison the texts of its two values are noted: A is what was expected, B what came. */
export const robActions_assert: Definition = {
  type,
  pack: 'expert',
  outsideToolbox: 'old',
  look: {
    category: 'action',
    shape: 'statement',
    fields: [{ name: 'TEXT', kind: 'text', preset: '' }],
    inputs: [value('OUT', 'Boolean')],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run(block, frame, { memory }) {
    if (frame.stage++ === 0) {
      memory.compared = null
      return out
    }
    const passed = frame.got[0] === true
    const isComparison = block.values?.OUT?.type === 'logic_compare'
    const [expected, got] =
      isComparison && memory.compared ? memory.compared.map(exactText) : ['true', String(passed)]
    memory.assert({
      id: block.id,
      text: field(block, 'TEXT'),
      expected: expected ?? '',
      got: got ?? '',
      passed,
    })
    return done
  },
  python: (py) => py.line(py.call('check', py.quote(py.field('TEXT')), py.value('OUT'))),
  example: [
    start,
    {
      type,
      fields: { TEXT: '1 = 1' },
      values: {
        OUT: { type: 'logic_compare', fields: { OP: 'EQ' }, values: { A: number(1), B: number(1) } },
      },
    },
    show(number(1)),
  ],
}
