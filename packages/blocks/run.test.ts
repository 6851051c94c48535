import { check } from '@botgarten/programs'
import { pythonFrom } from '@botgarten/programs/python'
import { cardConfig } from '@botgarten/simulation'
import { expect, test } from 'vitest'
import {
  block,
  calculate,
  compare,
  distance,
  forever,
  lamp,
  net,
  number,
  programOf,
  show,
  start,
} from '../programs/testing/build.ts'
import { lampsIn, run, shown } from '../programs/testing/run.ts'
import { addBlocks, type Template } from './index.ts'
import { expert } from './packs/expert/index.ts'

addBlocks(expert)

const [no, yes] = [compare('LT', number(2), number(1)), compare('LT', number(1), number(2))]

test('dividing by 0 stops at the block with a reason', () => {
  const { problem } = run([show(calculate('DIVIDE', number(1), number(0)))]).thread
  expect(problem).toMatchObject({ block: 'math_arithmetic', problem: 'problem.divisionByZero' })
})

test('a wait executes the branch of its first true condition', () => {
  const waiting = (...conditions: Template[]): Template => ({
    type: 'robControls_wait_for',
    mutation: { attrs: { wait: String(conditions.length - 1) } },
    values: Object.fromEntries(conditions.map((one, k) => [`WAIT${k}`, one])),
    statements: { DO0: [lamp('RED')], DO1: [lamp('GREEN')] },
  })
  expect(lampsIn([waiting(yes)])).toEqual([[0, 'red']])
  expect(lampsIn([waiting(no, yes)])).toEqual([[0, 'green']])
  expect(lampsIn([waiting(no)])).toEqual([])
})

const ofFour = ['a', 'b', 'c', 'd']
const letters: Template = {
  type: 'robLists_create_with',
  mutation: { attrs: { items: '4' } },
  values: Object.fromEntries(ofFour.map((TEXT, k) => [`ADD${k}`, block('text', { TEXT })])),
}

test.each([
  ['FIRST', null, 'FROM_START', 2, 'abc'],
  ['FROM_START', 1, 'LAST', null, 'bcd'],
  ['FROM_START', 1, 'FROM_START', 2, 'bc'],
])('part of a list of a, b, c, d: from %s %s to %s %s is %s', (WHERE1, at1, WHERE2, at2, expected) => {
  const values = {
    LIST: letters,
    ...(at1 !== null && { AT1: number(at1) }),
    ...(at2 !== null && { AT2: number(at2) }),
  }
  const part = block('robLists_getSublist', { WHERE1, WHERE2 }, values)
  const entry = (k: number) =>
    block('robLists_getIndex', { MODE: 'GET', WHERE: 'FROM_START' }, { VALUE: part, AT: number(k) })
  const entries = Array.from(expected, (_, k) => show(entry(k)))
  expect(shown(entries).join('')).toBe(expected)
  expect(run([show(entry(expected.length))]).thread.problem).toMatchObject({ problem: 'problem.noSuchEntry' })
})

const motor = (port: string) => block('ai_nn_output_node', { OUTPUTNODE: `MOTORPORT_${port}` })
const eye = block('ai_nn_input_node_ultrasonic', { INPUTNODE: 'ULTRASONIC_PORT_2' })

test('a network gives its outputs to the motors', () => {
  // The distance is 7 cm a tick; the first output is the sum of the inputs, the second half of it.
  const { log } = run([forever(net([eye], [motor('B'), motor('C')]))], 3)
  const inTick = (tick: number) => log.filter(([at, verb]) => at === tick && verb !== 'think')
  expect(inTick(2)).toEqual([
    [2, 'motor', 'B', 14],
    [2, 'motor', 'C', 7],
  ])
})

test('of two neurons for one motor the second may have each motor that is free', () => {
  const program = programOf([start, forever(net([eye], [motor('B'), motor('B')]))])
  const found = check(program, cardConfig).find(({ problem }) => problem === 'problem.sameMotor')
  expect(found?.block).toBe('ai_nn_output_node#2')
  expect(found?.fixes?.map((fix) => 'value' in fix && fix.value)).toEqual([
    ...['MOTORPORT_C', 'MOTORPORT_A', 'MOTORPORT_D'],
  ])
})

test.each<[name: string, code: string, row: Template]>([
  ['plus', 'show(number_text(1 + 2), 0, 0)', show(calculate('ADD', number(1), number(2)))],
  ['minus', 'show(number_text(1 - 2), 0, 0)', show(calculate('MINUS', number(1), number(2)))],
  ['times', 'show(number_text(1 * 2), 0, 0)', show(calculate('MULTIPLY', number(1), number(2)))],
  ['divided by', 'show(number_text(1 / 2), 0, 0)', show(calculate('DIVIDE', number(1), number(2)))],
  [
    'one or the other',
    'show(number_text(1 if 1 < 2 else 3), 0, 0)',
    show(block('logic_ternary', {}, { IF: yes, THEN: number(1), ELSE: number(3) })),
  ],
  ['leave the loop', '    break', forever(block('controls_flow_statements', { FLOW: 'BREAK' }))],
  ['next pass', '    continue', forever(block('controls_flow_statements', { FLOW: 'CONTINUE' }))],
  ['a distance in cm', 'show(number_text(left_eye.distance() / 10), 0, 0)', show(distance('2'))],
])('%s is %s in Python', (_name, code, row) => {
  const program = programOf([start, row])
  const input = { name: 'test', program, config: cardConfig, brains: {}, dialect: 'pybricks' } as const
  expect(pythonFrom(input, (key) => key).text.split('\n')).toContain(code)
})
