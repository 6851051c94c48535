import type { Template } from '../types.ts'
import { number, show } from './examples.ts'
import { variable } from './variables.ts'

const parameter = (name: string): Template => ({
  type: 'robLocalVariables_declare',
  mutation: { attrs: { next: 'false', declaration_type: 'Number' } },
  fields: { VAR: name, TYPE: 'Number' },
})

/** `f(x)` gives x + x. */
export const doubled: Template = {
  type: 'robProcedures_defreturn',
  mutation: { attrs: { declare: 'true', return_type: 'Number' } },
  fields: { NAME: 'f', TYPE: 'Number' },
  statements: { ST: [parameter('x')], STACK: [] },
  values: {
    RETURN: {
      type: 'math_arithmetic',
      fields: { OP: 'ADD' },
      values: { A: variable('x'), B: variable('x') },
    },
  },
}

export const showTwice: Template = show({
  type: 'robProcedures_callreturn',
  mutation: { attrs: { name: 'f', output_type: 'Number' }, args: [{ name: 'x', type: 'Number' }] },
  values: { ARG0: number(21) },
})

/** `f(n)` shows numbers above 0. */
export const saying: Template = {
  type: 'robProcedures_defnoreturn',
  mutation: { attrs: { declare: 'true' } },
  fields: { NAME: 'f' },
  statements: {
    ST: [parameter('n')],
    STACK: [
      {
        type: 'robProcedures_ifreturn',
        mutation: { attrs: { value: '0' } },
        values: {
          CONDITION: {
            type: 'logic_compare',
            fields: { OP: 'LT' },
            values: { A: variable('n'), B: number(0) },
          },
        },
      },
      show(variable('n')),
    ],
  },
}

export const sayIt: Template = {
  type: 'robProcedures_callnoreturn',
  mutation: { attrs: { name: 'f' }, args: [{ name: 'n', type: 'Number' }] },
  values: { ARG0: number(5) },
}
