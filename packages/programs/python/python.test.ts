import { addBlocks, definitions, type Definition, type Template } from '@botgarten/blocks'
import { expert } from '@botgarten/blocks/packs/expert'
import { learning } from '@botgarten/blocks/packs/learning'
import { cardConfig } from '@botgarten/simulation'
import { beforeAll, describe, expect, it } from 'vitest'
import { stacksOf } from '@botgarten/blocks'
import { block, number, programOf, show, start } from '../testing/build.ts'
import type { Program } from '../types.ts'
import { dialects, fileName, pythonFrom, type PythonInput } from './index.ts'

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
    expect(named('if', 'list')).toEqual(['if_', 'list_']))
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

  it('is said to one robot alone, where the other can do it', () => {
    const say = [block('robActions_sayText', {}, { OUT: text('Hi') })]
    expect(lines(say, { dialect: 'ev3dev2' }).at(-1)).toBe('sound.speak("Hi")')
  })
})

describe('a file', () => {
  it('of 2,000 blocks is there in less than two seconds', () => {
    const rows = Array.from({ length: 500 }, (_, k) => show(number(k)))
    const before = performance.now()
    const made = lines(rows)
    expect(performance.now() - before).toBeLessThan(2000)
    expect(made.filter((line) => line.startsWith('show(')).length).toBe(500)
  })

  it('knows for every line the blocks it belongs to', () => {
    const { text: file, lines: blocks } = python(
      programOf([start, block('robControls_wait_time', {}, { WAIT: number(5) })]),
    )
    const rows = file.trimEnd().split('\n')
    expect(blocks.length).toBe(rows.length)
    expect(blocks[rows.indexOf('wait(5)')]).toEqual(['robControls_wait_time', 'math_number'])
  })

  it('ends motors that go on turning on ev3dev', () => {
    const drive = block('robActions_motorDiff_on', { DIRECTION: 'FOREWARD' }, { POWER: number(30) })
    expect(lines([drive], { dialect: 'ev3dev2' }).at(-1)).toBe('wheels.off()')
  })
})
