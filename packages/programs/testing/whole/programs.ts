import { blockFrom, type Block, type Template } from '@botgarten/blocks'
import fc from 'fast-check'
import type { Program } from '../../types.ts'
import { rowsWith } from './typed-rows.ts'
import { kinds, made, one, palette, variable, type Any, type Kind } from './typed-values.ts'

const whole = rowsWith(true)
const inFunctions = rowsWith(false)
const { values, simple, rare } = whole
const { Number: number, Boolean: truth } = values
const listKinds = {
  Number: 'NumberList',
  String: 'StringList',
  Boolean: 'BooleanList',
  Colour: 'ColourList',
} as const

const maybeOff = fc.constantFrom(false, false, false, false, false, true)

const { rows } = fc.letrec<{ rows: Template[]; row: Template; nest: Template }>((tie) => {
  const inside = tie('rows')
  const around = (block: Any, ...names: readonly string[]): Any =>
    fc.tuple(block, fc.tuple(...names.map(() => inside))).map(([one, all]) => ({
      ...one,
      statements: Object.fromEntries(names.map((name, k) => [name, all[k]!])),
    }))
  const times = fc
    .integer({ min: 0, max: 4 })
    .map((n): Template => ({ type: 'math_number', fields: { NUM: String(n) } }))
  const leave = (OP: string, FLOW: string): Template => ({
    type: 'robControls_if',
    values: {
      IF0: {
        type: 'logic_compare',
        fields: { OP },
        values: { A: variable('n', 'Number'), B: variable('m', 'Number') },
      },
    },
    statements: { DO0: [{ type: 'controls_flow_statements', fields: { FLOW } }] },
  })
  const leaving = (block: Any): Any =>
    fc.tuple(block, fc.option(fc.tuple(one('LT', 'GTE'), one('BREAK', 'CONTINUE')))).map(([loop, how]) => {
      if (!how) return loop
      return { ...loop, statements: { DO: [...(loop.statements?.DO ?? []), leave(how[0], how[1])] } }
    })
  return {
    rows: fc
      .array(fc.tuple(tie('row'), maybeOff), { maxLength: 4, depthIdentifier: 'rows' })
      .map((list) => list.map(([row, disabled]) => ({ ...row, disabled }))),
    row: fc.oneof(
      { maxDepth: 3, depthIdentifier: 'rows' },
      { weight: 12, arbitrary: fc.oneof(...simple) },
      { weight: 1, arbitrary: fc.oneof(...rare, ...simple.slice(0, 6)) },
      { weight: 5, arbitrary: tie('nest') },
    ),
    nest: fc.oneof(
      leaving(around(made('robControls_loopForever'), 'DO')),
      leaving(around(made('controls_repeat_ext', {}, { TIMES: fc.oneof(times, number) }), 'DO')),
      leaving(around(made('controls_repeat', { TIMES: ['0', '2', '3'] }), 'DO')),
      leaving(around(made('controls_whileUntil', { MODE: ['WHILE', 'UNTIL'] }, { BOOL: truth }), 'DO')),
      leaving(
        around(made('robControls_for', { VAR: ['i', 'j'] }, { FROM: number, TO: number, BY: times }), 'DO'),
      ),
      leaving(
        fc.oneof(
          ...kinds.map((kind) =>
            around(
              made(
                'robControls_forEach',
                { TYPE: [kind], VAR: [`${kind}Entry`] },
                { LIST: values[listKinds[kind]] },
                () => ({ list_type: kind }),
              ),
              'DO',
            ),
          ),
        ),
      ),
      around(made('robControls_if', {}, { IF0: truth }), 'DO0'),
      around(
        made('robControls_if', {}, { IF0: truth, IF1: truth }, () => ({ elseif: '1' })),
        'DO0',
        'DO1',
      ),
      around(
        made('robControls_ifElse', {}, { IF0: truth, IF1: truth }, () => ({ elseif: '1', else: '1' })),
        'DO0',
        'DO1',
        'ELSE',
      ),
      around(
        made('robControls_wait_for', {}, { WAIT0: truth, WAIT1: truth }, () => ({ wait: '1' })),
        'DO0',
        'DO1',
      ),
      around(made('robControls_wait', {}, { WAIT0: truth }), 'DO0'),
    ),
  }
})

// ---- a whole program

const declared = (VAR: string, TYPE: string, VALUE: Template): Template => ({
  type: 'robGlobalVariables_declare',
  mutation: { attrs: { next: 'true', declaration_type: TYPE } },
  fields: { VAR, TYPE },
  values: { VALUE },
})
const emptyList = (kind: Kind, entries: readonly Template[]): Template => ({
  type: 'robLists_create_with',
  mutation: { attrs: { items: String(entries.length), list_type: kind } },
  fields: { LIST_TYPE: kind },
  values: Object.fromEntries(entries.map((entry, k) => [`ADD${k}`, entry])),
})
const three: { readonly [kind in Kind]: readonly Template[] } = {
  Number: ['3', '-1', '4.5'].map((NUM) => ({ type: 'math_number', fields: { NUM } })),
  String: ['a', '', '7'].map((TEXT) => ({ type: 'text', fields: { TEXT } })),
  Boolean: ['TRUE', 'FALSE'].map((BOOL) => ({ type: 'logic_boolean', fields: { BOOL } })),
  Colour: palette.slice(0, 2).map((COLOUR) => ({ type: 'robColour_picker', fields: { COLOUR } })),
}
const start: Template = {
  type: 'robControls_start',
  mutation: { attrs: { declare: 'true' } },
  statements: {
    ST: [
      ...['n', 'm', 'i'].map((name) => declared(name, 'Number', three.Number[0]!)),
      declared('t', 'String', three.String[0]!),
      declared('b', 'Boolean', three.Boolean[0]!),
      declared('c', 'Colour', three.Colour[0]!),
      ...kinds.map((kind) => declared(`${kind}s`, `Array_${kind}`, emptyList(kind, three[kind]))),
      declared('k', 'Connection', {
        type: 'robCommunication_startConnection',
        values: { ADDRESS: { type: 'text', fields: { TEXT: 'Bo 2' } } },
      }),
    ],
  },
}

const parameter = (VAR: string, TYPE: string): Template => ({
  type: 'robLocalVariables_declare',
  mutation: { attrs: { next: 'false', declaration_type: TYPE } },
  fields: { VAR, TYPE },
})
const shortRows = fc.array(
  fc.oneof(...inFunctions.simple.slice(0, 12), ...inFunctions.putting, ...inFunctions.rare.slice(2)),
  { maxLength: 2 },
)
const functions = fc
  .tuple(shortRows, inFunctions.values.Number, shortRows)
  .map(([first, RETURN, second]): Template[] => [
    {
      type: 'robProcedures_defreturn',
      mutation: { attrs: { declare: 'true', return_type: 'Number' } },
      fields: { NAME: 'double', TYPE: 'Number' },
      statements: { ST: [parameter('x', 'Number')], STACK: first },
      values: { RETURN },
    },
    {
      type: 'robProcedures_defnoreturn',
      mutation: { attrs: { declare: 'true' } },
      fields: { NAME: 'speak' },
      statements: { ST: [parameter('w', 'String')], STACK: second },
    },
  ])

function programOf(main: readonly Template[], made: readonly Template[]): Program {
  let count = 0
  const plant = (template: Template): Block => blockFrom(template, () => `b${count++}`)
  const stacks = [[start, ...main], ...made.map((block) => [block])]
  return {
    stacks: stacks.map((blocks) => ({ x: 0, y: 0, blocks: blocks.map(plant) })),
    config: { stacks: [] },
  }
}

/** Random programs of the whole language, well typed: every hole takes what its type says, and very few are gaps. */
export const wellTyped: fc.Arbitrary<Program> = fc
  .tuple(fc.array(rows, { minLength: 1, maxLength: 2 }), functions)
  .map(([main, made]) => programOf(main.flat(), made))
