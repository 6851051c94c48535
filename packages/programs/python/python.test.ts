import { addBlocks, definitions, type Definition, type Template } from '@botgarten/blocks'
import { expert } from '@botgarten/blocks/packs/expert'
import { learning } from '@botgarten/blocks/packs/learning'
import { timed } from '@botgarten/numbers/testing/processor'
import { emptyBrain } from '@botgarten/learning/neural-network/brain'
import { cardConfig } from '@botgarten/simulation'
import { beforeAll, describe, expect, it } from 'vitest'
import { stacksOf } from '@botgarten/blocks'
import { block, number, programOf, show, start } from '../testing/build.ts'
import type { Program } from '../types.ts'
import { centresIn, dialects, fileName, pythonFrom, type PythonInput } from './index.ts'

beforeAll(() => {
  addBlocks(expert)
  addBlocks(learning)
})

/** Message keys stand for themselves. */
const say = (key: string) => key

const python = (program: Program, more: Partial<PythonInput> = {}) =>
  pythonFrom({ name: 'test', program, config: cardConfig, brains: {}, dialect: 'pybricks', ...more }, say)

/** The file without its head. */
const lines = (rows: readonly Template[], more: Partial<PythonInput> = {}) =>
  python(programOf([start, ...rows]), more)
    .text.trimEnd()
    .split('\n')
    .slice(2)

const text = (value: string) => block('text', { TEXT: value })

const declared = (VAR: string, value: Template, TYPE = 'Number'): Template =>
  block('robGlobalVariables_declare', { VAR, TYPE }, { VALUE: value })
const withVariables = (...made: readonly Template[]): Template => ({
  ...{ type: 'robControls_start', mutation: { attrs: { declare: 'true' } } },
  statements: { ST: made },
})
const set = (VAR: string, value: Template): Template => ({
  ...block('variables_set', { VAR }, { VALUE: value }),
  mutation: { attrs: { datatype: 'Number' } },
})
const variable = (VAR: string): Template => ({
  ...block('variables_get', { VAR }),
  mutation: { attrs: { datatype: 'Number' } },
})

describe('every block', () => {
  const all = Object.values({ ...definitions, ...expert, ...learning } as {
    readonly [type: string]: Definition
  })

  it.each(all.map((definition) => [definition.type, definition] as const))(
    '%s: its example is a file for both robots, or says what is missing',
    (_type, { example, python: facet }) => {
      for (const dialect of dialects) {
        const [main = [], ...others] = stacksOf(example)
        const { text: file, notes } = python(programOf(main, ...others), { dialect })
        expect(file).toMatch(/^(#[^\n]*\n)+/)
        expect(file).not.toMatch(/undefined|\[object|NaN/)
        if (typeof facet === 'object' && 'missing' in facet) expect(notes.length).toBeGreaterThan(0)
      }
    },
  )
})

describe('names', () => {
  const named = (...names: readonly string[]) =>
    python(programOf([withVariables(...names.map((name, k) => declared(name, number(k))))]))
      .text.split('\n')
      .filter((line) => / = \d+$/.test(line))
      .map((line) => line.replace(/ = \d+$/, ''))

  it('that Python keeps for itself get an underscore', () =>
    expect(named('if', 'list', 'input')).toEqual(['if_', 'list_', 'input_']))
  it('that the file uses itself make way too', () =>
    expect(named('sqrt', 'wait', 'ValueError', 'choice')).toEqual([
      'sqrt_',
      'wait_',
      'ValueError_',
      'choice_',
    ]))
  it('keep their umlauts', () => expect(named('ä', 'größe')).toEqual(['ä', 'größe']))
  it('lose what no name may hold', () =>
    expect(named('Robot 1', '2nd', '🙂')).toEqual(['Robot_1', 'x_2nd', 'x']))
  it('that become one are told apart', () =>
    expect(named('a b', 'a_b', 'a-b')).toEqual(['a_b', 'a_b_2', 'a_b_3']))
  it('of the file make way for the child’s', () => {
    const program = programOf([
      withVariables(declared('speed', number(3))),
      block('robActions_motor_on', { MOTORPORT: 'A' }, { POWER: variable('speed') }),
    ])
    const { text: file } = python(program)
    expect(file).toContain('motor_a.run(speed_2(speed))')
    expect(file).toContain('def speed_2(percent):')
  })
  it('of files are names that every system takes', () => {
    expect(['Freundschaft', 'Meine Übung 1', '../x', ''].map(fileName)).toEqual([
      'freundschaft.py',
      'meine_übung_1.py',
      'x.py',
      'x.py',
    ])
  })
})

it('variables that a function changes are made once, before it, and are global in it', () => {
  const change = block('robMath_change', {}, { VAR: variable('x'), DELTA: number(1) })
  const add = block('robProcedures_defnoreturn', { NAME: 'add' }, {}, { STACK: [change] })
  const call = { type: 'robProcedures_callnoreturn', mutation: { attrs: { name: 'add' } } }
  const { text: file } = python(programOf([withVariables(declared('x', number(7))), call], [add]))
  const rows = file.trimEnd().split('\n')
  const making = 'x = 7'
  const define = ['def add():', '    global x', '    x += 1']
  expect(rows.filter((row) => row === making || define.includes(row))).toEqual([making, ...define])
  expect(rows.at(-1)).toBe('add()')
})

it('tables of a network are named after their content', () => {
  const neuron = (id: string, bias: number) => ({ id, activation: 'identity' as const, bias })
  const layers = [[neuron('eye', 0)], [neuron('wheel', 0.5)]]
  const brain = { ...emptyBrain, layers, weights: { eye: { wheel: 2 } } }
  const bias = show(block('robSensors_get_bias', { NAME: 'wheel' }))
  expect(lines([bias], { brains: { robControls_start: brain } })).toEqual(
    expect.arrayContaining([
      ...['net_inputs = {"eye": 0}', 'net_outputs = {"wheel": 0}'],
      ...['net_weights = {"eye": {"wheel": 2}}', 'net_biases = {"wheel": 0.5}'],
      'show(number_text(net_biases["wheel"]), 0, 0)',
    ]),
  )
})

describe('comments of helpers', () => {
  it.each([
    ['pybricks', 'python.helper.show'],
    ['ev3dev2', 'python.helper.show'],
    ['spike', 'python.helper.letters'],
  ] as const)('on %s say what its display does: %s', (dialect, key) => {
    expect(lines([show(number(1))], { dialect })).toContain(`    # ${key}`)
  })
})

describe('what has to sit at a port', () => {
  it('is the left motor, the right one, or the kind of another one', () => {
    const program = programOf([
      start,
      ...['B', 'C'].map((MOTORPORT) => block('robActions_motor_on', { MOTORPORT }, { POWER: number(30) })),
    ])
    const words = (key: string, facts: object = {}) => [key, ...(Object.values(facts) as unknown[])].join(' ')
    const { text: file } = pythonFrom(
      { ...{ name: 'test', program, config: cardConfig, brains: {} }, dialect: 'pybricks' },
      words,
    )
    expect(file).toContain('python.plug B python.device.right')
    expect(file).toContain('python.plug C python.device.left')
  })
})

describe('groups of colours', () => {
  const group = show(block('ai_sorting_group', { AS: 'NUMBER', SENSORPORT: '1' }))
  const page = { source: 'readings', centres: [[10, 0, 2], [0, 4, 10]] } // prettier-ignore

  it.each([
    ['at the top', page],
    ['behind another page', { source: 'things', centres: [[1]], pages: [page] }],
  ])('that the playground has found go along: %s', (_where, sorting) => {
    const rows = lines([group], { learned: { centres: centresIn(sorting) } })
    expect(rows).toContain('centres = [[255, 0, 51], [0, 102, 255]]')
  })

  it.each([undefined, {}, { source: 'readings', centres: [[1, 2]] }, { source: 'readings', centres: 'x' }])(
    'are none where the playground holds %j',
    (sorting) => expect(centresIn(sorting)).toEqual([]),
  )
})

describe('texts', () => {
  it.each([
    ['quotes', 'sie sagt "hallo"', `'sie sagt "hallo"'`],
    ['both quotes', `"it's"`, `'"it\\'s"'`],
    ['a new line', 'a\nb', '"a\\nb"'],
    ['a backslash', 'a\\b', '"a\\\\b"'],
    ['a sign that is not seen', 'a\u0000b', '"a\\x00b"'],
  ])('with %s stay what they are', (_what, value, code) => {
    expect(lines([show(text(value))]).at(-1)).toBe(`show(${code}, 0, 0)`)
  })

  it('of a child’s note never become code', () => {
    expect(lines([block('text_comment', { TEXT: 'a\nimport os\r\u2028b' })])).toEqual([
      '',
      '# a',
      '# import os',
      '# b',
    ])
  })
})

describe('what is not finished', () => {
  it('raises an error with the child’s words', () => {
    const { text: file, notes } = python(programOf([start, block('robControls_wait_time')]))
    expect(file).toContain('raise NotImplementedError("problem.missingValue.title")')
    expect(notes).toEqual([{ block: 'robControls_wait_time', text: 'problem.missingValue.title', gap: true }])
  })

  it('is only a comment where the child wants no errors', () => {
    const rows = lines([block('robControls_wait_time')], { gaps: false })
    expect(rows).toEqual(['', '# problem.missingValue.title'])
  })

  it('differs from what the brick lacks', () => {
    const { notes } = python(
      programOf([
        start,
        block('robActions_sayText', {}, { OUT: text('Hi') }),
        block('robControls_wait_time'),
      ]),
    )
    expect(notes.map(({ block: id, gap }) => [id, gap])).toEqual([
      ['robActions_sayText', false],
      ['robControls_wait_time', true],
    ])
  })

  it('takes no import along', () => {
    expect(lines([set('x', block('robColour_picker', { COLOUR: '#B30006' }))])).toEqual([
      '',
      'raise NotImplementedError("problem.noSuchVariable.title")',
    ])
  })

  it('leaves the rest of the program', () => {
    expect(lines([block('foreign'), block('robControls_wait_time', {}, { WAIT: number(500) })])).toEqual([
      'from pybricks.tools import wait',
      '',
      'raise NotImplementedError("problem.unknownBlock.title")',
      'wait(500)',
    ])
  })

  it('a sensor that is not plugged in is asked for', () => {
    const touch = block('robSensors_touch_getSample', { MODE: 'PRESSED', SENSORPORT: '1', SLOT: '' })
    const rows = lines([block('robControls_wait_for', {}, { WAIT0: touch })])
    expect(rows.at(-1)).toBe('raise NotImplementedError("problem.noTouchSensorAnywhere.title")')
  })
})

describe('what the brick cannot do', () => {
  it('stands in the file as a comment, and the rest comes', () => {
    const rows = lines([
      block('robActions_sayText', {}, { OUT: text('Hi') }),
      block('robControls_wait_time', {}, { WAIT: number(500) }),
    ])
    expect(rows.slice(-2)).toEqual(['# python.missing.speech', 'wait(500)'])
  })

  it('stands once where it comes again, and belongs to all its blocks', () => {
    const say = (id: string) => ({ ...block('robActions_sayText', {}, { OUT: text('Hi') }), id })
    const { text: file, lines: blocks, notes } = python(programOf([start, say('one'), say('two')]))
    const rows = file.trimEnd().split('\n')
    expect(rows.filter((row) => row === '# python.missing.speech')).toHaveLength(1)
    expect(notes).toHaveLength(2)
    const ids = notes.map(({ block: id }) => id)
    expect(blocks[rows.indexOf('# python.missing.speech')]).toEqual(expect.arrayContaining(ids))
  })

  it('is said to one robot alone, where the other can do it', () => {
    const say = [block('robActions_sayText', {}, { OUT: text('Hi') })]
    expect(lines(say, { dialect: 'ev3dev2' }).at(-1)).toBe('sound.speak("Hi")')
  })
})

describe('deciding', () => {
  const yes = block('logic_boolean', { BOOL: 'TRUE' })
  const no = block('logic_boolean', { BOOL: 'FALSE' })
  const decide = (IF0: Template | null, n: number, ELSE: readonly Template[]): Template => ({
    ...{ type: 'robControls_ifElse', mutation: { attrs: { else: '1' } } },
    ...{ values: IF0 ? { IF0 } : {}, statements: { DO0: [show(number(n))], ELSE } },
  })
  const heads = (rows: readonly string[]) => rows.filter((row) => /^ *(if|elif|else|raise)/.test(row))

  it('again where the other one ends goes on as `elif`', () => {
    const rows = lines([decide(yes, 1, [decide(no, 2, [show(number(3))])])])
    expect(heads(rows)).toEqual(['if True:', 'elif False:', 'else:'])
  })

  it('stays in the `else` where something stands beside it', () => {
    const rows = lines([decide(yes, 1, [decide(no, 2, []), show(number(3))])])
    expect(heads(rows)).toEqual(['if True:', 'else:', '    if False:', '    else:'])
  })

  it('with a gap leaves the one before complete', () => {
    const rows = lines([decide(yes, 1, [decide(null, 2, [])])])
    expect(heads(rows)).toEqual([
      'if True:',
      'else:',
      '    raise NotImplementedError("problem.missingValue.title")',
    ])
  })
})

describe('a file', () => {
  it('of 2,000 blocks is there in less than two seconds of the processor', () => {
    const rows = Array.from({ length: 500 }, (_, k) => show(number(k)))
    const { result: made, seconds } = timed(() => lines(rows))
    expect(seconds).toBeLessThan(2)
    expect(made.filter((line) => line.startsWith('show(')).length).toBe(500)
    // So much flash has the EV3 for programs (lib/pbio/platform/ev3/pbdrvconfig.h, BLOCK_DEVICE_EV3_SIZE).
    expect(made.join('\n').length).toBeLessThan((1024 * 1024 * 3) / 4)
  })

  it('knows for every line the blocks it belongs to', () => {
    const { text: file, lines: blocks } = python(
      programOf([start, block('robControls_wait_time', {}, { WAIT: number(5) })]),
    )
    const rows = file.trimEnd().split('\n')
    expect(blocks.length).toBe(rows.length)
    expect(blocks[rows.indexOf('wait(5)')]).toEqual(['robControls_wait_time', 'math_number'])
  })

  it('has a head whose lines run with no block', () => {
    const drive = block('robActions_motorDiff_on', { DIRECTION: 'FOREWARD' }, { POWER: number(30) })
    const { text: file, head } = python(programOf([start, drive]))
    const rows = file.split('\n')
    expect(rows.slice(0, head).join('\n')).toContain('left_motor = Motor(Port.C)')
    expect(rows.slice(0, head).join('\n')).not.toContain('def ')
  })

  it('ends motors that go on turning on ev3dev', () => {
    const drive = block('robActions_motorDiff_on', { DIRECTION: 'FOREWARD' }, { POWER: number(30) })
    expect(lines([drive], { dialect: 'ev3dev2' }).at(-1)).toBe('wheels.off()')
  })
})
