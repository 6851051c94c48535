import { describe, expect, it } from 'vitest'
import type { Template } from '@botgarten/blocks'
import { block, calculate, colour, compare, lamp, number, show } from '../testing/build.ts'
import { lampsIn, run, shown } from '../testing/run.ts'

describe('rules 8 and 9: driving', () => {
  const power = (percent: number) => ({ POWER: number(percent) })
  const order = (rows: readonly Template[]) => run(rows).log[0]

  it('speeds are cut to −100..100', () => {
    expect(order([block('robActions_motorDiff_on', { DIRECTION: 'FOREWARD' }, power(150))])).toEqual([
      0,
      'move',
      100,
      100,
      undefined,
    ])
    expect(order([block('robActions_motor_on', { MOTORPORT: 'B' }, power(-150))])).toEqual([
      0,
      'motor',
      'B',
      -100,
    ])
  })

  it('backward and left turn the sign', () => {
    expect(order([block('robActions_motorDiff_on', { DIRECTION: 'BACKWARD' }, power(30))])).toEqual([
      0,
      'move',
      -30,
      -30,
      undefined,
    ])
    expect(order([block('robActions_motorDiff_turn', { DIRECTION: 'LEFT' }, power(30))])).toEqual([
      0,
      'move',
      -30,
      30,
      undefined,
    ])
    expect(order([block('robActions_motorDiff_turn', { DIRECTION: 'RIGHT' }, power(30))])).toEqual([
      0,
      'move',
      30,
      -30,
      undefined,
    ])
  })

  it('a turn of the wheel, 5.6 · π cm, is 360 degrees of it; backwards with a negative distance is forward', () => {
    const drive = (direction: string, distance: number) =>
      order([
        block(
          'robActions_motorDiff_on_for',
          { DIRECTION: direction },
          { ...power(30), DISTANCE: number(distance) },
        ),
      ])
    expect(drive('FOREWARD', 5.6 * Math.PI)).toEqual([0, 'move', 30, 30, 360])
    expect(drive('BACKWARDS', -5.6 * Math.PI)).toEqual([0, 'move', 30, 30, 360])
    expect(drive('FOREWARD', -5.6 * Math.PI)).toEqual([0, 'move', -30, -30, 360])
  })

  it('a full turn on the spot is track ÷ wheel turns of each wheel', () => {
    const [tick, verb, left, right, degrees] = order([
      block('robActions_motorDiff_turn_for', { DIRECTION: 'RIGHT' }, { ...power(30), DEGREE: number(360) }),
    ])!
    expect([tick, verb, left, right]).toEqual([0, 'move', 30, -30])
    expect(degrees).toBeCloseTo((360 * 18) / 5.6, 9)
  })

  it('the next block comes in the tick of arrival; a move that is none stops and goes on', () => {
    const drive = (distance: number) =>
      block(
        'robActions_motorDiff_on_for',
        { DIRECTION: 'FOREWARD' },
        { ...power(30), DISTANCE: number(distance) },
      )
    expect(run([drive(20), lamp('RED')]).log.at(-1)).toEqual([3, 'led', 'red'])
    expect(run([drive(0), lamp('RED')]).log).toEqual([
      [0, 'move', 0, 0, undefined],
      [0, 'led', 'red'],
    ])
  })
})

describe('rule 10: numbers', () => {
  it('dividing by zero fails at the block that divides', () => {
    const { thread, whole } = run([show(calculate('DIVIDE', number(1), number(0)))])
    expect(thread).toMatchObject({
      ended: true,
      problem: { block: 'math_arithmetic', problem: 'problem.divisionByZero', stops: true },
    })
    expect(whole).toEqual([
      [0, 'stop'],
      [0, 'tone', 0, null],
    ])
  })

  it('a number without end fails', () => {
    const { thread } = run([show(calculate('MULTIPLY', number(1e200), number(1e200)))])
    expect(thread.problem?.problem).toBe('problem.tooBigNumber')
  })
})

describe('rule 11: comparing', () => {
  const holds = (operator: string, a: Template, b: Template) =>
    lampsIn([
      block(
        'robControls_ifElse',
        {},
        { IF0: compare(operator, a, b) },
        { DO0: [lamp('GREEN')], ELSE: [lamp('RED')] },
      ),
    ])[0]?.[1] === 'green'

  it.each([
    ['EQ', [false, true, false]],
    ['NEQ', [true, false, true]],
    ['LT', [true, false, false]],
    ['LTE', [true, true, false]],
    ['GT', [false, false, true]],
    ['GTE', [false, true, true]],
  ] as const)('%s of 1 with 2, 1 and 0', (operator, expected) => {
    expect([2, 1, 0].map((b) => holds(operator, number(1), number(b)))).toEqual(expected)
  })

  it('colours are equal without regard to letter case', () => {
    expect(holds('EQ', colour('#b30006'), colour('#B30006'))).toBe(true)
    expect(holds('NEQ', colour('#B30006'), colour('#0057A6'))).toBe(true)
  })

  it('colours have no order, and are no numbers', () => {
    const problem = (a: Template, b: Template) =>
      run([block('robControls_if', {}, { IF0: compare('LT', a, b) })]).thread.problem?.problem
    expect(problem(colour('#B30006'), colour('#0057A6'))).toBe('problem.coloursHaveNoOrder')
    expect(problem(colour('#B30006'), number(1))).toBe('problem.cannotCompare')
  })
})

describe('rule 12: text of a value', () => {
  it.each([
    [0.5, '0.5'],
    [1 / 3, '0.3333'],
    [-0.00001, '0'],
    [42, '42'],
    [1e15, '1000000000000000'],
    [2.5001, '2.5001'],
  ])('%s is shown as %s', (x, text) => {
    expect(shown([show(number(x))])).toEqual([text])
  })

  it('0.1 + 0.2 is shown as 0.3', () => {
    expect(shown([show(calculate('ADD', number(0.1), number(0.2)))])).toEqual(['0.3'])
  })

  it('truth and colours have the names of the EV3', () => {
    expect(shown([show(compare('LT', number(1), number(2)))])).toEqual(['true'])
    expect(shown([show(colour('#b30006'))])).toEqual(['RED'])
  })
})

describe('rule 13: the display', () => {
  it('rounds row and column and cuts them to 8 × 17', () => {
    const at = (column: number, row: number) =>
      run([block('robActions_display_text', {}, { OUT: number(1), COL: number(column), ROW: number(row) })])
        .log[0]
    expect(at(-3, 99)).toEqual([0, 'display', 7, 0, '1'])
    expect(at(99, 1.5)).toEqual([0, 'display', 2, 16, '1'])
  })
})

describe('rule 14: a tone', () => {
  const tone = (frequency: number, ms: number) =>
    block('robActions_play_tone', {}, { FREQUENCE: number(frequency), DURATION: number(ms) })

  it('is over before the next block comes', () => {
    expect(run([tone(300, 100), lamp('RED')]).log).toEqual([
      [0, 'tone', 300, 0.1],
      [6, 'led', 'red'],
    ])
  })

  it('of no time does not sound, of negative frequency is silent', () => {
    expect(run([tone(300, 0)]).log).toEqual([])
    expect(run([tone(-5, 100)]).log).toEqual([[0, 'tone', 0, 0.1]])
  })
})
