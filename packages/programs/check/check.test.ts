import { describe, expect, it } from 'vitest'
import { addBlocks, knowMaps, type Template } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { check } from '../index.ts'
import { fits } from './check.ts'
import {
  block,
  calculate,
  colour,
  compare,
  distance,
  forever,
  lamp,
  net,
  number,
  programOf,
  show,
  start,
} from '../testing/build.ts'

/** The cards' robot: colour at port 1, distance at 2 and 3. */
const sockets = {
  sensors: { 1: { kind: 'colour' }, 2: { kind: 'ultrasonic' }, 3: { kind: 'ultrasonic' } },
} as const

const findings = (...rows: Template[]) => check(programOf([start, ...rows]), sockets)
const problems = (...rows: Template[]) => findings(...rows).map(({ problem }) => problem)

const eye = (port: string) => block('ai_nn_input_node_ultrasonic', { INPUTNODE: `ULTRASONIC_PORT_${port}` })
const seen = (port: string) =>
  block('ai_nn_input_node_coloursensor_color', { COLOUR: '#00642E', SENSORPORT: port })
const motor = block('ai_nn_output_node', { OUTPUTNODE: 'MOTORPORT_C' })

describe('a sensor at the wrong port', () => {
  it('names both ports and offers the right one: the picture of the colour neuron at port 2', () => {
    expect(findings(net([seen('2')], [motor]))).toEqual([
      {
        block: 'ai_nn_input_node_coloursensor_color',
        problem: 'problem.noColourSensorHere',
        facts: { port: '2', other: '1' },
        fixes: [{ field: 'SENSORPORT', value: '1', words: 'problem.fix.port', facts: { port: '1' } }],
        stops: true,
      },
    ])
  })

  it('offers every right port, in the words of the field', () => {
    const [finding] = findings(net([eye('4')], [motor]))
    expect(finding).toMatchObject({
      problem: 'problem.noDistanceSensorEmpty',
      facts: { port: '4', other: '2' },
    })
    expect(finding?.fixes?.map(({ value, plug }) => [value, plug?.port])).toEqual([
      ['ULTRASONIC_PORT_2', undefined],
      ['ULTRASONIC_PORT_3', undefined],
      ['ULTRASONIC_PORT_4', '4'],
    ])
  })

  it('says so where the robot has no such sensor at all, and offers to plug one in at a free port', () => {
    const program = programOf([start, net([seen('2')], [motor])])
    expect(check(program, { sensors: { 2: { kind: 'ultrasonic' } } })).toMatchObject([
      {
        problem: 'problem.noColourSensorAnywhere',
        fixes: [{ field: 'SENSORPORT', value: '1', plug: { port: '1', kind: 'colour' } }],
      },
    ])
  })

  it('has no way out where every port is taken', () => {
    const program = programOf([start, net([seen('2')], [motor])])
    const sensors = Object.fromEntries(['1', '2', '3', '4'].map((port) => [port, { kind: 'touch' as const }]))
    expect(check(program, { sensors })).toMatchObject([{ fixes: [] }])
  })

  it.each([
    ['robSensors_touch_getSample', 'touch', 'Touch'],
    ['robSensors_gyro_getSample', 'gyro', 'Gyro'],
    ['robSensors_gyro_reset', 'gyro', 'Gyro'],
    ['robSensors_infrared_getSample', 'infrared', 'Infrared'],
    ['robSensors_sound_getSample', 'sound', 'Sound'],
    ['robSensors_compass_getSample', 'compass', 'Compass'],
    ['robSensors_odometry_getSample', 'position', 'Position'],
  ] as const)('%s needs its sensor, and one tap plugs it in', (type, kind, name) => {
    const reading = block(type, { SENSORPORT: '4' })
    const program = programOf([start, type.endsWith('reset') ? reading : show(reading)])
    expect(check(program, sockets)).toMatchObject([
      {
        problem: `problem.no${name}SensorAnywhere`,
        facts: { port: '4' },
        fixes: [{ plug: { port: '4', kind } }],
      },
    ])
    expect(check(program, { sensors: { ...sockets.sensors, 4: { kind } } })).toEqual([])
  })

  it('a fix fixes it', () => {
    expect(findings(net([seen('1')], [motor]))).toEqual([])
    expect(problems(show(distance('1')))).toEqual(['problem.noDistanceSensorHere'])
    expect(problems(show(distance('2')))).toEqual([])
  })
})

describe('start blocks', () => {
  it('a program needs one', () => {
    expect(check(programOf([lamp('RED')]), sockets)).toEqual([
      { block: '', problem: 'problem.noStart', stops: true },
    ])
  })

  it('and not two', () => {
    expect(check(programOf([start], [start, lamp('RED')]), sockets)).toEqual([
      { block: 'robControls_start#2', problem: 'problem.secondStart', stops: true },
    ])
  })

  it('blocks beside it may lie about half done', () => {
    expect(
      check(programOf([start], [calculate('ADD', number(1), number(1))], [show(distance('4'))]), sockets),
    ).toEqual([])
  })
})

describe('networks', () => {
  it('need an input and an output', () => {
    expect(problems(net([], [motor]))).toEqual(['problem.noInputs'])
    expect(problems(net([eye('2')], []))).toEqual(['problem.noOutputs'])
    expect(problems(block('ai_neural_network'))).toEqual(['problem.noInputs'])
  })

  it('run with an empty row, which is only a hint', () => {
    expect(findings(net([eye('2'), null], [motor]))).toEqual([
      { block: 'ai_easy_list', problem: 'problem.emptyRow', stops: false },
    ])
  })

  it('run with two neurons for one motor, which is only a hint at the lower one, with the motors that are free', () => {
    expect(findings(net([eye('2')], [motor, motor]))).toMatchObject([
      { block: 'ai_nn_output_node#2', problem: 'problem.sameMotor', facts: { port: 'C' }, stops: false },
    ])
    const [finding] = findings(net([eye('2')], [motor, motor]))
    expect(finding?.fixes?.map(({ value }) => value)).toEqual(['MOTORPORT_B', 'MOTORPORT_A', 'MOTORPORT_D'])
  })

  const whole = () => net([eye('2')], [motor])
  const loose = { problem: 'problem.looseNetwork', stops: false }

  it('that hang loose have knobs that do nothing: it is said, with the loop that they go into', () => {
    expect(check(programOf([start, forever()], [whole()]), sockets)).toEqual([
      { block: 'ai_neural_network', ...loose, putIn: 'problem.fix.intoLoop' },
    ])
    expect(check(programOf([start], [whole()]), sockets)).toEqual([
      { block: 'ai_neural_network', ...loose, putIn: 'problem.fix.intoNewLoop' },
    ])
    expect(check(programOf([start], [forever(whole())]), sockets)).toMatchObject([loose])
  })

  it('hang loose too where there is no start block, or it is switched off', () => {
    const problem = 'problem.noStart'
    expect(check(programOf([whole()]), sockets)).toMatchObject([{ problem }, loose])
    const off = { ...start, disabled: true }
    expect(check(programOf([off, forever(whole())]), sockets)).toMatchObject([{ problem }, loose])
  })

  it('hang loose in a function that nobody calls, and run in one that is called', () => {
    const call = { ...block('robProcedures_callnoreturn'), mutation: { attrs: { name: 'think' } } }
    const define = block('robProcedures_defnoreturn', { NAME: 'think' }, {}, { STACK: [whole()] })
    expect(check(programOf([start], [define]), sockets)).toMatchObject([loose])
    expect(
      check(programOf([start, forever(call)], [define]), sockets).map(({ problem }) => problem),
    ).not.toContain(loose.problem)
  })

  it('are never come to behind a loop that never ends', () => {
    expect(check(programOf([start, forever(), lamp('RED'), whole()]), sockets)).toMatchObject([
      { block: 'actions_bricklight_on_ev3', problem: 'problem.neverReached' },
      { block: 'ai_neural_network', problem: 'problem.networkBehind', putIn: 'problem.fix.intoLoop' },
    ])
  })

  it('are left in peace where a child has switched them off, and where they run', () => {
    expect(check(programOf([start], [{ ...whole(), disabled: true }]), sockets)).toEqual([])
    expect(problems(forever(block('robControls_if', {}, {}, { DO0: [whole()] })))).not.toContain(
      loose.problem,
    )
  })

  it('take no output among the inputs', () => {
    expect(findings(net([motor], [motor]))).toMatchObject([
      { block: 'ai_nn_output_node', problem: 'problem.wrongKind' },
    ])
  })
})

describe('gaps and wrong blocks', () => {
  it('a missing value is said at the block with the gap', () => {
    expect(findings(block('robControls_wait_time'))).toEqual([
      {
        block: 'robControls_wait_time',
        problem: 'problem.missingValue',
        facts: { input: 'WAIT' },
        stops: true,
      },
    ])
  })

  it('a block that is switched off leaves a gap, or is not looked at', () => {
    const off = { ...number(1), disabled: true }
    expect(problems(block('robControls_wait_time', {}, { WAIT: off }))).toEqual(['problem.missingValue'])
    expect(problems({ ...block('robControls_wait_time'), disabled: true })).toEqual([])
  })

  it('a value of the wrong kind, a statement as value, a value as statement', () => {
    expect(findings(block('robControls_wait_time', {}, { WAIT: colour('#B30006') }))).toMatchObject([
      { block: 'robColour_picker', problem: 'problem.wrongKind' },
    ])
    expect(problems(block('robControls_wait_time', {}, { WAIT: lamp('RED') }))).toEqual(['problem.wrongKind'])
    expect(problems(number(1))).toEqual(['problem.wrongKind'])
    expect(problems(start)).toEqual(['problem.wrongKind'])
  })

  it('the colour sensor gives a colour or a number, as its mode says', () => {
    const reading = (MODE: string) => block('robSensors_colour_getSample', { MODE, SENSORPORT: '1' })
    const waiting = (MODE: string) => problems(block('robControls_wait_time', {}, { WAIT: reading(MODE) }))
    expect(waiting('LIGHT')).toEqual([])
    expect(waiting('COLOUR')).toEqual(['problem.wrongKind'])
    expect(problems(show(reading('RGB')))).toEqual(['problem.unknownChoice'])
  })

  it('unknown blocks, choices, numbers and parts are named', () => {
    expect(findings(block('robActions_play_file'))).toEqual([
      { block: 'robActions_play_file', problem: 'problem.unknownBlock', stops: false },
    ])
    expect(problems(show(calculate('POWER', number(2), number(3))))).toEqual(['problem.unknownChoice'])
    expect(problems(show(block('math_number', { NUM: 'zwei' })))).toEqual(['problem.notANumber'])
    expect(problems(block('actions_bricklight_on_ev3', { COLOUR: 'RED', MODE: 'FLASH' }))).toEqual([
      'problem.unknownPart',
    ])
    expect(
      problems(
        block(
          'robControls_if',
          {},
          { IF0: compare('EQ', number(1), number(1)), IF1: compare('EQ', number(1), number(1)) },
        ),
      ),
    ).toEqual(['problem.unknownPart'])
  })

  it('rows of a layer that its mutation does not count are not silently lost', () => {
    const list = {
      ...net([eye('2'), eye('3')], [motor]).values!.INPUT_LAYER!,
      mutation: { attrs: { items: '1', list_type: 'InputNode' } },
    }
    const rest = net([], [motor]).values!.OUTPUT_LAYER!
    expect(problems(block('ai_neural_network', {}, { INPUT_LAYER: list, OUTPUT_LAYER: rest }))).toEqual([
      'problem.unknownPart',
    ])
  })

  it('colours of a file may be written in either case', () => {
    expect(problems(show(colour('#b30006')))).toEqual([])
  })
})

describe('comparing', () => {
  const decide = (condition: Template) => problems(block('robControls_if', {}, { IF0: condition }))

  it('colours have no order and are no numbers', () => {
    expect(decide(compare('LT', colour('#B30006'), colour('#0057A6')))).toEqual([
      'problem.coloursHaveNoOrder',
    ])
    expect(decide(compare('EQ', colour('#B30006'), number(1)))).toEqual(['problem.cannotCompare'])
    expect(decide(compare('EQ', colour('#B30006'), colour('#0057A6')))).toEqual([])
  })
})

describe('loops', () => {
  it('that do nothing are fine', () => {
    expect(problems(forever())).toEqual([])
  })

  it('that never end hint at what comes after them', () => {
    expect(findings(forever(lamp('RED')), lamp('GREEN'))).toEqual([
      { block: 'actions_bricklight_on_ev3#2', problem: 'problem.neverReached', stops: false },
    ])
  })

  it('are looked into', () => {
    expect(problems(forever(forever(show(distance('4')))))).toEqual(['problem.noDistanceSensorEmpty'])
  })
})

describe('a value fits', () => {
  it('where its type is accepted, or nothing is known of one of the two', () => {
    expect(fits('Number', ['Number', 'String'])).toBe(true)
    expect(fits('Number', 'any')).toBe(true)
    expect(fits('any', ['Boolean'])).toBe(true)
    expect(fits('Number', ['Boolean'])).toBe(false)
  })
})

describe('a map to learn on', () => {
  const map = (START: string, FINISH: string) =>
    block('ai_q_learning_states_and_actions_map', { MAP: 'MAP_CITY', START, FINISH })

  it('has the stations that its drawing has', () => {
    addBlocks(learning)
    expect(problems(map('0', '499'))).toEqual([])
    knowMaps({ maps: ['city'], stations: { city: 20 } })
    expect(problems(map('0', '19'))).toEqual([])
    const nowhere = { problem: 'problem.noSuchStation', facts: { last: 19 }, stops: true }
    for (const row of [map('0', '20'), map('20', '0')]) expect(findings(row)).toMatchObject([nowhere])
  })

  it('asks for a way between two places', () => {
    addBlocks(learning)
    expect(problems(map('3', '3'))).toEqual(['problem.startIsGoal'])
  })
})
