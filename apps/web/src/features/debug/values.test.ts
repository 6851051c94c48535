import { expect, it } from 'vitest'
import { valuesAtBlocks, valueText } from './values.ts'

const de = { locale: 'de', yes: 'wahr', no: 'falsch' }
const en = { locale: 'en', yes: 'true', no: 'false' }

it('values are said as a child reads them', () => {
  expect(valueText(-2.5, de)).toBe('−2,5')
  expect(valueText(1 / 3, en)).toBe('0.3333')
  expect([valueText(true, de), valueText(false, en)]).toEqual(['wahr', 'false'])
  expect([valueText('Bo', en), valueText('#B30006', en), valueText(null, en)]).toEqual([
    '“Bo”',
    '#B30006',
    '–',
  ])
  expect(valueText([1.5, 'a', []], de)).toBe('[1,5; “a”; []]')
  expect(valueText([1, 2, 3, 4, 5, 6, 7, 8, 9], en)).toBe('[1, 2, 3, 4, 5, 6, 7, 8 …]')
  expect(valueText([1, 2, 3, 4, 5, 6, 7, 8], en)).toBe('[1, 2, 3, 4, 5, 6, 7, 8]')
})

it('a variable’s value stands at every block that names it, a parameter’s only in its function', () => {
  const use = (id: string, name: string) => ({ id, type: 'variables_get', fields: { VAR: name } })
  const set = (id: string, name: string, value: string) => ({
    ...{ id, type: 'variables_set', fields: { VAR: name }, values: { VALUE: use(value, name) } },
  })
  const program = {
    config: { stacks: [] },
    stacks: [
      {
        x: 0,
        y: 0,
        blocks: [{ id: 's', type: 'robControls_start' }, set('a', 'x', 'b'), set('c', 'p', 'd')],
      },
      {
        ...{ x: 0, y: 9 },
        blocks: [
          {
            id: 'f',
            type: 'robProcedures_defnoreturn',
            statements: { STACK: [set('e', 'x', 'g'), set('h', 'p', 'i')] },
          },
        ],
      },
    ],
  }
  const variables = [
    { name: 'x', value: 1, of: null },
    { name: 'p', value: 2, of: 'f' },
    { name: 'q', value: 3, of: 'elsewhere' },
    // Only functions have parameters.
    { name: 'p', value: 4, of: 's' },
  ]
  expect(Object.fromEntries(valuesAtBlocks(program, variables, en))).toEqual({
    ...{ a: '1', b: '1', e: '1', g: '1', h: '2', i: '2' },
  })
})
