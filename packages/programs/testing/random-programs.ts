import fc from 'fast-check'
import { blockFrom, type Template } from '@botgarten/blocks'
import type { Program } from '../types.ts'

type Values = { readonly [input: string]: Template | null }

/** A hole is a gap where the template is null. */
const filled = (values: Values) =>
  Object.fromEntries(Object.entries(values).filter((entry): entry is [string, Template] => entry[1] !== null))

const number = fc
  .oneof(
    { weight: 6, arbitrary: fc.integer({ min: -3, max: 60 }) },
    { weight: 3, arbitrary: fc.constantFrom(0.5, 2.5, -0.25, 1e308, 1e200, 150, 300, 997, 0) },
  )
  .map((x): Template => ({ type: 'math_number', fields: { NUM: String(x) } }))

const sensor = fc
  .constantFrom('2', '3', '2', '3', '2', '3', '4')
  .map((port): Template => ({ type: 'robSensors_ultrasonic_getSample', fields: { SENSORPORT: port } }))

const rarely = <T>(arbitrary: fc.Arbitrary<T>) => fc.option(arbitrary, { freq: 40, nil: null })

const { value } = fc.letrec<{ value: Template; sum: Template }>((tie) => ({
  value: fc.oneof({ maxDepth: 3, withCrossShrink: true }, number, sensor, tie('sum')),
  sum: fc
    .tuple(fc.constantFrom('ADD', 'MINUS', 'MULTIPLY', 'DIVIDE'), tie('value'), tie('value'))
    .map(([OP, A, B]): Template => ({ type: 'math_arithmetic', fields: { OP }, values: { A, B } })),
}))
const hole = rarely(value)

const condition = rarely(
  fc
    .tuple(fc.constantFrom('EQ', 'NEQ', 'LT', 'LTE', 'GT', 'GTE'), hole, hole)
    .map(([OP, A, B]): Template => ({ type: 'logic_compare', fields: { OP }, values: filled({ A, B }) })),
)

const block = (type: string, values: Values, fields: Template['fields'] = {}): Template => ({
  type,
  fields,
  values: filled(values),
})

const layer = (list_type: string, rows: readonly Template[]): Template => ({
  type: 'ai_easy_list',
  mutation: { attrs: { items: String(rows.length), list_type } },
  values: Object.fromEntries(rows.map((row, k) => [`ADD${k}`, row])),
})

const maybeOff = fc.constantFrom(false, false, false, false, true)

const net = fc
  .tuple(
    fc.array(fc.tuple(fc.constantFrom('2', '3'), maybeOff), { maxLength: 3 }),
    fc.array(fc.tuple(fc.constantFrom('A', 'B', 'C', 'D'), maybeOff), { maxLength: 3 }),
  )
  .map(([inputs, outputs]): Template => {
    const read = inputs.map(([port, disabled]) => ({
      type: 'ai_nn_input_node_ultrasonic',
      fields: { INPUTNODE: `ULTRASONIC_PORT_${port}` },
      disabled,
    }))
    const drive = outputs.map(([port, disabled]) => ({
      type: 'ai_nn_output_node',
      fields: { OUTPUTNODE: `MOTORPORT_${port}` },
      disabled,
    }))
    return block('ai_neural_network', {
      INPUT_LAYER: layer('InputNode', read),
      OUTPUT_LAYER: layer('OutputNode', drive),
    })
  })

const way = fc.constantFrom('FOREWARD', 'BACKWARD', 'BACKWARDS', 'LEFT', 'RIGHT')

const simple = fc.oneof(
  hole.map((WAIT) => block('robControls_wait_time', { WAIT })),
  fc.tuple(hole, way).map(([POWER, DIRECTION]) => block('robActions_motorDiff_on', { POWER }, { DIRECTION })),
  fc
    .tuple(hole, hole, way)
    .map(([POWER, DISTANCE, DIRECTION]) =>
      block('robActions_motorDiff_on_for', { POWER, DISTANCE }, { DIRECTION }),
    ),
  fc
    .tuple(hole, hole, way)
    .map(([POWER, DEGREE, DIRECTION]) =>
      block('robActions_motorDiff_turn_for', { POWER, DEGREE }, { DIRECTION }),
    ),
  hole.map((POWER) => block('robActions_motor_on', { POWER }, { MOTORPORT: 'A' })),
  fc.constant(block('robActions_motorDiff_stop', {})),
  fc.constant(block('actions_bricklight_on_ev3', {}, { COLOUR: 'RED', MODE: 'ON' })),
  fc.tuple(hole, hole, hole).map(([OUT, COL, ROW]) => block('robActions_display_text', { OUT, COL, ROW })),
  fc.tuple(hole, hole).map(([FREQUENCE, DURATION]) => block('robActions_play_tone', { FREQUENCE, DURATION })),
  net,
)

const { rows } = fc.letrec<{ rows: Template[]; statement: Template; nest: Template }>((tie) => ({
  rows: fc
    .array(fc.tuple(tie('statement'), maybeOff), { maxLength: 4, depthIdentifier: 'rows' })
    .map((list) => list.map(([statement, disabled]) => ({ ...statement, disabled }))),
  statement: fc.oneof(
    { maxDepth: 3, depthIdentifier: 'rows' },
    { weight: 3, arbitrary: simple },
    { weight: 4, arbitrary: tie('nest') },
  ),
  nest: fc.oneof(
    tie('rows').map((DO): Template => ({ type: 'robControls_loopForever', statements: { DO } })),
    fc
      .tuple(hole, tie('rows'))
      .map(([TIMES, DO]): Template => ({ ...block('controls_repeat_ext', { TIMES }), statements: { DO } })),
    fc
      .tuple(condition, tie('rows'))
      .map(([IF0, DO0]): Template => ({ ...block('robControls_if', { IF0 }), statements: { DO0 } })),
    fc.tuple(condition, tie('rows'), tie('rows')).map(([IF0, DO0, ELSE]): Template => ({
      ...block('robControls_ifElse', { IF0 }),
      statements: { DO0, ELSE },
    })),
  ),
}))

/** Random programs: nested loops and decisions, gaps, sensors that are not there, numbers without end. */
export const randomPrograms: fc.Arbitrary<Program> = rows.map((templates) => {
  let count = 0
  const start: Template = { type: 'robControls_start' }
  const blocks = [start, ...templates].map((template) => blockFrom(template, () => `b${count++}`))
  return { stacks: [{ x: 0, y: 0, blocks }], config: { stacks: [] } }
})
