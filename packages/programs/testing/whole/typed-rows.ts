import type { Template } from '@botgarten/blocks'
import fc from 'fast-check'
import {
  call,
  kinds,
  listVariable,
  made,
  motors,
  names,
  valuesWith,
  variable,
  where,
  type Any,
  type Kind,
} from './typed-values.ts'

// ---- rows

const neurons = (of: readonly Any[], list_type: string): Any =>
  fc
    .array(fc.tuple(fc.oneof(...of), fc.constantFrom(false, false, false, true)), {
      minLength: 1,
      maxLength: 3,
    })
    .map((rows): Template => ({
      type: 'ai_easy_list',
      mutation: { attrs: { items: String(rows.length), list_type } },
      values: Object.fromEntries(rows.map(([row, disabled], k) => [`ADD${k}`, { ...row, disabled }])),
    }))
/** Of ten networks one or two have hidden layers. */
const hidden = fc.oneof(
  { weight: 5, arbitrary: fc.constant([]) },
  { weight: 1, arbitrary: fc.array(fc.constantFrom('RELU', 'TANH'), { minLength: 1, maxLength: 2 }) },
)
const behind = (first: Template, activations: readonly string[]): Template =>
  activations.reduce<Template>(
    (LAYER, ACTIVATION) => ({
      type: 'ai_nn_hidden_layer',
      fields: { NEURONS: '2', ACTIVATION },
      values: { LAYER },
    }),
    first,
  )
const net = fc
  .tuple(
    neurons(
      [
        made('ai_nn_input_node_ultrasonic', { INPUTNODE: ['ULTRASONIC_PORT_2', 'ULTRASONIC_PORT_3'] }),
        made('ai_nn_input_node_coloursensor_light', { SENSORPORT: ['1'] }),
        made('ai_nn_input_node_coloursensor_color', { COLOUR: ['#B30006', '#FFFFFF'], SENSORPORT: ['1'] }),
        made('ai_nn_input_node_coloursensor_rgb_channel', {
          COLOUR: ['#FF0000', '#00FF00', '#0000FF'],
          SENSORPORT: ['1'],
        }),
      ],
      'InputNode',
    ),
    neurons(
      [
        made('ai_nn_output_node', { OUTPUTNODE: motors.map((port) => `MOTORPORT_${port}`) }),
        made('ai_nn_output_node_led', { OUTPUTNODE: ['#00642E', '#F7D118', '#B30006'] }),
        made('ai_nn_output_node_text', { OUTPUTNODE: ['Hallo', 'Halt'] }),
        made('ai_nn_output_node_sound'),
      ],
      'OutputNode',
    ),
    hidden,
  )
  .map(([first, OUTPUT_LAYER, activations]): Template => ({
    type: 'ai_neural_network',
    values: { INPUT_LAYER: behind(first, activations), OUTPUT_LAYER },
  }))

/** Blocks of a row that hold no others. `calls`: may they call functions? */
export function rowsWith(calls: boolean) {
  const values = valuesWith(calls)
  const { Number: number, Boolean: truth, String: words, Colour: colour, Connection: connection } = values
  const anything = fc.oneof(number, truth, words, colour, values.NumberList)
  const hundredMs = fc
    .integer({ min: 0, max: 120 })
    .map((ms): Template => ({ type: 'math_number', fields: { NUM: String(ms) } }))
  const shortly = fc.oneof({ weight: 5, arbitrary: hundredMs }, { weight: 1, arbitrary: number })
  const variableOf = (kind: Kind, VAR: string) => ({ VAR: fc.constant(variable(VAR, kind)) })

  const ways = ['FOREWARD', 'BACKWARD', 'BACKWARDS', 'LEFT', 'RIGHT']
  const pictures = ['EYESOPEN', 'FLOWERS']
  const listOf = {
    Number: 'NumberList',
    String: 'StringList',
    Boolean: 'BooleanList',
    Colour: 'ColourList',
  } as const
  const putting = kinds.flatMap((kind) => {
    const holes = { LIST: fc.oneof(fc.constant(listVariable(kind)), values[listOf[kind]]), TO: values[kind] }
    return [
      made(
        'robLists_setIndex',
        { MODE: ['SET', 'INSERT'], WHERE: where.slice(0, 2) },
        { ...holes, AT: number },
        () => ({ at: 'true' }),
      ),
      made('robLists_setIndex', { MODE: ['SET', 'INSERT'], WHERE: where.slice(2) }, holes, () => ({
        at: 'false',
      })),
      made(
        'robLists_getIndex',
        { MODE: ['REMOVE'], WHERE: where.slice(2) },
        { VALUE: fc.constant(listVariable(kind)) },
        () => ({ statement: 'true', at: 'false' }),
      ),
      made('variables_set', { VAR: [names[kind][0]!] }, { VALUE: values[kind] }, () => ({ datatype: kind })),
      made('variables_set', { VAR: [`${kind}s`] }, { VALUE: values[listOf[kind]] }, () => ({
        datatype: `Array_${kind}`,
      })),
    ]
  })

  const simple: readonly Any[] = [
    made('robControls_wait_time', {}, { WAIT: shortly }),
    made('robActions_motorDiff_on', { DIRECTION: ways }, { POWER: number }),
    made('robActions_motorDiff_on_for', { DIRECTION: ways }, { POWER: number, DISTANCE: number }),
    made('robActions_motorDiff_turn', { DIRECTION: ways }, { POWER: number }),
    made('robActions_motorDiff_turn_for', { DIRECTION: ways }, { POWER: number, DEGREE: number }),
    made('robActions_motorDiff_curve', { DIRECTION: ways }, { POWER_LEFT: number, POWER_RIGHT: number }),
    made(
      'robActions_motorDiff_curve_for',
      { DIRECTION: ways },
      { POWER_LEFT: number, POWER_RIGHT: number, DISTANCE: number },
    ),
    made('robActions_motorDiff_stop'),
    made('robActions_motor_on', { MOTORPORT: motors }, { POWER: number }),
    made(
      'robActions_motor_on_for',
      { MOTORPORT: motors, MOTORROTATION: ['ROTATIONS', 'DEGREE'] },
      { POWER: number, VALUE: number },
    ),
    made('robActions_motor_setPower', { MOTORPORT: motors }, { POWER: number }),
    made('robActions_motor_stop', { MOTORPORT: motors, MODE: ['FLOAT', 'NONFLOAT'] }),
    made('robActions_display_text', {}, { OUT: anything, COL: number, ROW: number }),
    made('robActions_display_clear'),
    made('robActions_display_picture', { PICTURE: pictures }, { X: number, Y: number }),
    made('robActions_display_picture_new', { PICTURE: pictures }),
    made('actions_bricklight_on_ev3', {
      COLOUR: ['GREEN', 'ORANGE', 'RED'],
      MODE: ['ON', 'FLASH', 'DOUBLE_FLASH'],
    }),
    made('actions_bricklight_off_ev3', { MODE: ['OFF', 'RESET'] }),
    made('robActions_brickLight_on', {
      SWITCH_COLOR: ['GREEN', 'RED'],
      SWITCH_BLINK: ['ON', 'FLASH', 'DOUBLE_FLASH'],
    }),
    made('robActions_brickLight_off'),
    made('robActions_brickLight_reset'),
    made('robActions_play_tone', {}, { FREQUENCE: number, DURATION: shortly }),
    made('mbedActions_play_note', { DURATION: ['125', '250'], FREQUENCE: ['261.626', '440'] }),
    made('robActions_play_file', { FILE: ['0', '1', '2', '3', '4'] }),
    made('robActions_play_setVolume', {}, { VOLUME: number }),
    made('robActions_setLanguage', { LANGUAGE: ['GERMAN', 'ENGLISH'] }),
    made('robActions_sayText', {}, { OUT: anything }),
    made('robActions_sayText_parameters', {}, { OUT: anything, VOICESPEED: number, VOICEPITCH: number }),
    made('robSensors_encoder_reset', { SENSORPORT: motors }),
    made('robSensors_timer_reset', { SENSORPORT: ['1', '2'] }),
    made('robSensors_compass_calibrate', { SENSORPORT: ['1'] }),
    made('robActions_assert', { TEXT: ['pos-1', 'pos-2'] }, { OUT: truth }),
    made('robActions_debug', {}, { OUT: anything }),
    made('text_comment', { TEXT: ['hm'] }),
    made('robActions_eval_stmt', { STMTEXPRESSION: ['', ' '] }),
    made('robMath_change', {}, { ...variableOf('Number', 'n'), DELTA: number }).filter(
      ({ values }) => values?.VAR !== undefined,
    ),
    made('robText_append', {}, { ...variableOf('String', 't'), TEXT: anything }).filter(
      ({ values }) => values?.VAR !== undefined,
    ),
    made('robCommunication_sendBlock', {}, { sendData: words, CONNECTION: connection }),
    made('variables_set', { VAR: ['k'] }, { VALUE: connection }, () => ({ datatype: 'Connection' })),
    ...(calls ? [call('robProcedures_callnoreturn', 'speak', [words])] : []),
    (calls ? call('robProcedures_callreturn', 'double', [number]) : number).map((VALUE): Template => ({
      type: 'variables_set',
      mutation: { attrs: { datatype: 'Number' } },
      fields: { VAR: 'm' },
      values: { VALUE },
    })),
    net,
    ...putting,
    made('robActions_set_inputneuron_val', { NAME: ['n1'] }, { VALUE: number }),
    made('robActions_set_weight', { FROM: ['n1'], TO: ['n2'] }, { VALUE: number }),
    made('robActions_set_bias', { NAME: ['n2'] }, { VALUE: number }),
    made(
      'robActions_change_weight',
      { FROM: ['n1'], TO: ['n2'], CHANGE: ['SET', 'INCR'] },
      { VALUE: number },
    ),
    made('robActions_change_bias', { NAME: ['n2'], CHANGE: ['SET', 'INCR'] }, { VALUE: number }),
    made('robActions_outputneuron', { NAME: ['n2'] }, { VALUE: fc.constant(variable('m', 'Number')) }).filter(
      ({ values }) => values?.VALUE !== undefined,
    ),
    made('robActions_outputneuron_wo_var', { NAME: ['n2'] }),
    made('robActions_inputneuron', { NAME: ['n1'] }, { VALUE: number }).chain((inner) =>
      fc.constant<Template>({ type: 'robActions_NNstep', statements: { IONEURON: [inner] } }),
    ),
  ]
  // Blocks that mostly end a program on this robot.
  const rare: readonly Any[] = [
    made('robSensors_gyro_reset', { SENSORPORT: ['2'] }),
    made('controls_flow_statements', { FLOW: ['BREAK', 'CONTINUE'] }),
    made('robProcedures_ifreturn', {}, { CONDITION: truth, VALUE: number }, () => ({ value: '1' })),
  ]

  return { values, simple, rare, putting }
}
