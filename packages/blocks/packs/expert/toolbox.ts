import { number, text } from '../../parts/examples.ts'
import { withRest, withRow, type ToolboxCategory } from '../../toolbox.ts'
import type { Block, Category, Template } from '../../types.ts'
import { coreToolbox } from '../core/toolbox.ts'
import { learningToolbox } from '../learning/toolbox.ts'
import type { TypeIn } from '../packs.ts'
import { blocks as table } from './blocks.ts'

type Fields = { readonly [name: string]: string }

const block = (
  type: TypeIn<'expert'>,
  fields: Fields = {},
  values: Template['values'] = {},
  attrs: Fields = {},
): Template => ({
  type,
  ...(Object.keys(attrs).length > 0 && { mutation: { attrs } }),
  ...(Object.keys(fields).length > 0 && { fields }),
  ...(Object.keys(values).length > 0 && { values }),
})

const compare: Template = { type: 'logic_compare', fields: { OP: 'EQ' } }

/** A block of the cards with other fields. */
const other = (type: string, fields: Fields, attrs?: Fields): Template => ({
  type,
  fields,
  ...(attrs && { mutation: { attrs } }),
})

const sensor = (type: string, mode: string, port: string): Template =>
  other(type, { MODE: mode, SENSORPORT: port, SLOT: '' }, { mode })

const text_ = { TYPE: 'String', PROTOCOL: 'BLUETOOTH', CHANNEL: '-1' }

const more: { readonly [category in Category]?: readonly Template[] } = {
  control: [
    block('controls_whileUntil', { MODE: 'UNTIL' }),
    block('robControls_for', { VAR: 'i' }, { FROM: number(1), TO: number(10), BY: number(1) }),
    block('robControls_forEach', { TYPE: 'Number', VAR: 'x' }, {}, { list_type: 'Number' }),
    block('controls_flow_statements', { FLOW: 'BREAK' }),
    block('robControls_wait_for', {}, { WAIT0: compare }),
    block('robControls_wait'),
    block('text_comment', { TEXT: '' }),
  ],
  action: [
    block(
      'robActions_motor_on_for',
      { MOTORPORT: 'B', MOTORROTATION: 'ROTATIONS' },
      { POWER: number(30), VALUE: number(1) },
    ),
    block('robActions_motor_getPower', { MOTORPORT: 'B' }),
    block('robActions_motor_setPower', { MOTORPORT: 'B' }, { POWER: number(30) }),
    block('robActions_motor_stop', { MOTORPORT: 'B', MODE: 'FLOAT' }),
    block(
      'robActions_motorDiff_curve',
      { DIRECTION: 'FOREWARD' },
      { POWER_LEFT: number(10), POWER_RIGHT: number(30) },
    ),
    block(
      'robActions_motorDiff_curve_for',
      { DIRECTION: 'FOREWARD' },
      { POWER_LEFT: number(10), POWER_RIGHT: number(30), DISTANCE: number(20) },
    ),
    block('robActions_display_picture_new', { PICTURE: 'EYESOPEN' }),
    other('actions_bricklight_off_ev3', { MODE: 'RESET' }),
    block('mbedActions_play_note', { DURATION: '500', FREQUENCE: '261.626' }),
    block('robActions_play_file', { FILE: '0' }),
    block('robActions_play_setVolume', {}, { VOLUME: number(50) }),
    block('robActions_play_getVolume'),
    block('robActions_setLanguage', { LANGUAGE: 'GERMAN' }),
    block('robActions_sayText', {}, { OUT: text('Bo') }),
    block(
      'robActions_sayText_parameters',
      {},
      { OUT: text('Bo'), VOICESPEED: number(30), VOICEPITCH: number(50) },
    ),
  ],
  sensors: [
    sensor('robSensors_ultrasonic_getSample', 'PRESENCE', '2'),
    sensor('robSensors_colour_getSample', 'RGB', '1'),
    block('robSensors_compass_calibrate', { SENSORPORT: '1', SLOT: '' }),
    sensor('robSensors_irseeker_getSample', 'MODULATED', '1'),
    sensor('robSensors_htcolour_getSample', 'COLOUR', '1'),
  ],
  logic: [
    block('logic_operation', { OP: 'AND' }),
    block('logic_negate'),
    block('logic_boolean', { BOOL: 'TRUE' }),
    block('logic_null'),
    block('logic_ternary'),
  ],
  math: [
    block('math_single', { OP: 'ROOT' }),
    block('math_trig', { OP: 'SIN' }),
    block('math_constant', { CONSTANT: 'PI' }),
    block('math_number_property', { PROPERTY: 'EVEN' }, {}, { divisor_input: 'false' }),
    block('robMath_change', {}, { DELTA: number(1) }),
    block('math_round', { OP: 'ROUND' }),
    block('math_on_list', { OP: 'SUM' }, {}, { op: 'SUM' }),
    block('math_modulo'),
    block('math_constrain', {}, { LOW: number(1), HIGH: number(100) }),
    block('math_random_int', {}, { FROM: number(1), TO: number(100) }),
    block('math_random_float'),
    block('math_cast_toString'),
    block('math_cast_toChar'),
  ],
  text: [
    block('robText_join', {}, {}, { items: '2' }),
    block('robText_append'),
    block('text_cast_string_toNumber'),
    block('text_cast_char_toNumber', {}, { AT: number(0) }),
    block('robActions_eval_expr', { EXPRESSION: '1 + 2', TYPE: 'Number' }, {}, { type: 'Number' }),
  ],
  network: [
    block('robActions_NNstep'),
    block('robActions_set_inputneuron_val', { NAME: 'n1' }, { VALUE: number(0) }),
    block('robSensors_get_outputneuron_val', { NAME: 'n2' }),
    block('robActions_set_weight', { FROM: 'n1', TO: 'n2' }, { VALUE: number(0) }),
    block('robActions_set_bias', { NAME: 'n2' }, { VALUE: number(0) }),
    block('robSensors_get_weight', { FROM: 'n1', TO: 'n2' }),
    block('robSensors_get_bias', { NAME: 'n2' }),
  ],
}

const newOnes: readonly ToolboxCategory[] = [
  {
    category: 'lists',
    blocks: [
      block('robLists_create_with', { LIST_TYPE: 'Number' }, {}, { items: '0', list_type: 'Number' }),
      block(
        'robLists_create_with',
        { LIST_TYPE: 'Number' },
        { ADD0: number(0), ADD1: number(0), ADD2: number(0) },
        { items: '3', list_type: 'Number' },
      ),
      block('robLists_repeat', { LIST_TYPE: 'Number' }, { NUM: number(5) }, { list_type: 'Number' }),
      block('robLists_length'),
      block('robLists_isEmpty'),
      block('robLists_indexOf', { END: 'FIRST' }),
      block(
        'robLists_getIndex',
        { MODE: 'GET', WHERE: 'FROM_START' },
        {},
        { statement: 'false', at: 'true' },
      ),
      block('robLists_setIndex', { MODE: 'SET', WHERE: 'FROM_START' }, {}, { at: 'true' }),
      block(
        'robLists_getSublist',
        { WHERE1: 'FROM_START', WHERE2: 'LAST' },
        {},
        { at1: 'true', at2: 'false' },
      ),
    ],
  },
  {
    category: 'functions',
    blocks: [
      block('robProcedures_defnoreturn', { NAME: 'f' }, {}, { declare: 'false' }),
      block(
        'robProcedures_defreturn',
        { NAME: 'f', TYPE: 'Number' },
        {},
        { declare: 'false', return_type: 'Number' },
      ),
      block('robProcedures_ifreturn', {}, {}, { value: '0' }),
    ],
  },
  {
    category: 'messages',
    blocks: [
      block('robCommunication_startConnection', {}, { ADDRESS: text('Bo 2') }),
      block('robCommunication_waitForConnection'),
      block('robCommunication_sendBlock', text_, { sendData: text('Bo') }, { datatype: 'String' }),
      block('robCommunication_receiveBlock', text_, {}, { datatype: 'String' }),
    ],
  },
]

/** What the playgrounds need stands at the end. */
const plain = learningToolbox.reduce(withRow, coreToolbox)
const last: readonly Category[] = ['network', 'q-learning', 'sorting']

const withMore = ({ category, blocks }: ToolboxCategory): ToolboxCategory => ({
  category,
  blocks: [...blocks, ...(more[category] ?? [])],
})

const rows = [
  ...plain.filter(({ category }) => !last.includes(category)).map(withMore),
  ...newOnes,
  ...plain.filter(({ category }) => last.includes(category)).map(withMore),
]

/**
 * Open Roberta's expert toolbox: everything of the plain one, then what is new. Variables and calls of functions depend
 * on the program: `variableBlocks`, `callBlocks`.
 */
export const expertToolbox = withRest(rows, table)

/** What a program's variable can be used with: its value, setting it, and what its type allows. */
export function variableBlocks(name: string, type: string): readonly Template[] {
  const get = block('variables_get', { VAR: name }, {}, { datatype: type })
  const set = block('variables_set', { VAR: name }, {}, { datatype: type })
  if (type === 'Number') return [get, set, block('robMath_change', {}, { VAR: get, DELTA: number(1) })]
  return type === 'String'
    ? [get, set, block('robText_append', {}, { VAR: get, TEXT: text('') })]
    : [get, set]
}

/** The call of a function that a block makes; null where the block makes none. */
export function callBlock({ type, fields, statements }: Block): Template | null {
  const name = fields?.NAME ?? ''
  const args = (statements?.ST ?? []).flatMap(({ fields: parameter }) =>
    parameter ? [{ name: parameter.VAR ?? '', type: parameter.TYPE ?? '' }] : [],
  )
  if (type === 'robProcedures_defnoreturn')
    return { type: 'robProcedures_callnoreturn', mutation: { attrs: { name }, args } }
  if (type !== 'robProcedures_defreturn') return null
  const attrs = { name, output_type: fields?.TYPE ?? 'Number' }
  return { type: 'robProcedures_callreturn', mutation: { attrs, args } }
}
