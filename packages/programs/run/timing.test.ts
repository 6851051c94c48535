import { describe, expect, it } from 'vitest'
import { indexProgram, runThread, startThread } from '../index.ts'
import {
  block,
  calculate,
  compare,
  distance,
  forever,
  lamp,
  number,
  programOf,
  repeat,
  show,
  start,
  wait,
} from '../testing/build.ts'
import { nextTick, recordingRobot } from '../testing/recording-robot.ts'
import { lampsIn, run } from '../testing/run.ts'

describe('rule 1: the first stack under a start block runs', () => {
  it('other stacks do nothing', () => {
    const recording = recordingRobot()
    const index = indexProgram(programOf([lamp('RED')], [start, lamp('GREEN')]))
    runThread(startThread(index), index, recording.context)
    expect(recording.log.filter(([, verb]) => verb === 'led')).toEqual([[0, 'led', 'green']])
  })

  it('a program without a start block ends at once', () => {
    const recording = recordingRobot()
    const index = indexProgram(programOf([lamp('RED')]))
    const thread = startThread(index)
    runThread(thread, index, recording.context)
    expect(thread).toMatchObject({ ended: true, problem: null })
  })

  it('blocks that are switched off are not there', () => {
    expect(lampsIn([{ ...lamp('RED'), disabled: true }, lamp('GREEN')])).toEqual([[0, 'green']])
  })
})

it('each evaluated condition is a decision, true or false', () => {
  const when = (a: number, b: number) =>
    block('robControls_if', {}, { IF0: compare('LT', number(a), number(b)) }, { DO0: [lamp('RED')] })
  const { thread } = run([repeat(number(3), when(1, 2), when(2, 1)), lamp('GREEN')])
  expect(thread.decisions).toBe(3 * 2)
})

describe('rule 3: 1,000 blocks a tick', () => {
  /** The lamp is block n of the run: start, repeat, its number, n − 4 further turns, the lamp. */
  const lampAs = (n: number) => run([repeat(number(n - 3)), lamp('RED')]).log

  it.each([
    [1000, 0],
    [1001, 1],
    [2000, 1],
    [2001, 2],
  ])('block %s comes in tick %s', (n, tick) => {
    expect(lampAs(n)).toEqual([[tick, 'led', 'red']])
  })

  it('value blocks count: six a sum that is shown', () => {
    const sum = show(calculate('ADD', number(1), number(1)))
    const { log } = run(Array.from({ length: 200 }, () => sum))
    const inTick = (tick: number) => log.filter(([t]) => t === tick).length
    expect([inTick(0), inTick(1)]).toEqual([166, 34])
  })

  it('a loop that does nothing never freezes', () => {
    const { thread, endedIn } = run([forever()], 10)
    expect([thread.ended, endedIn]).toEqual([false, 9])
  })

  it('a wait costs nothing while it lasts', () => {
    expect(run([wait(100), repeat(number(995)), lamp('RED')]).log).toEqual([[6, 'led', 'red']])
  })
})

describe('rule 4: a back edge waits when its pass acted', () => {
  it('a lamp in a loop is lit once a tick', () => {
    expect(lampsIn([repeat(number(3), lamp('RED'))])).toEqual([
      [0, 'red'],
      [1, 'red'],
      [2, 'red'],
    ])
  })

  it('what acted before the loop does not make the loop wait', () => {
    const { log } = run([lamp('RED'), repeat(number(5), wait(0)), lamp('GREEN')])
    expect(log).toEqual([
      [0, 'led', 'red'],
      [0, 'led', 'green'],
    ])
  })

  it('an outer loop waits for what an inner loop did, even in an earlier tick', () => {
    const onlyFirst = block(
      'robControls_if',
      {},
      { IF0: compare('EQ', number(1), number(1)) },
      { DO0: [lamp('RED')] },
    )
    expect(lampsIn([repeat(number(2), repeat(number(2), onlyFirst), repeat(number(2)))])).toEqual([
      [0, 'red'],
      [1, 'red'],
      [2, 'red'],
      [3, 'red'],
    ])
  })

  it('sensing counts as acting, a loop’s own head does not', () => {
    expect(
      run([
        repeat(
          number(3),
          block('robControls_wait_time', {}, { WAIT: calculate('MULTIPLY', distance(), number(0)) }),
        ),
        lamp('RED'),
      ]).log,
    ).toEqual([[2, 'led', 'red']])
    expect(run([repeat(distance(), wait(0)), lamp('RED')]).log).toEqual([[0, 'led', 'red']])
  })
})

describe('rule 5: a wait lasts the fewest whole ticks that are not shorter', () => {
  it.each([
    [500, 30],
    [100, 6],
    [10, 1],
    [17, 2],
    [1000, 60],
    [0, 0],
    [-5, 0],
  ])('%s ms are %s ticks', (ms, ticks) => {
    expect(run([wait(ms), lamp('RED')]).log).toEqual([[ticks, 'led', 'red']])
  })

  it('also after ten minutes, where seconds are no longer exact', () => {
    const recording = recordingRobot()
    recording.tick = 35_999
    nextTick(recording)
    const index = indexProgram(programOf([start, wait(500), lamp('RED')]))
    const thread = startThread(index)
    while (!thread.ended) {
      runThread(thread, index, recording.context)
      nextTick(recording)
    }
    expect(recording.log[0]).toEqual([36_030, 'led', 'red'])
  })
})

describe('rule 6: repeat', () => {
  it.each([
    [2.5, 3],
    [3, 3],
    [0, 0],
    [-2, 0],
  ])('%s times are %s passes', (times, passes) => {
    expect(lampsIn([repeat(number(times), lamp('RED'))])).toHaveLength(passes)
  })
})
