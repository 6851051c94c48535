import { describe, expect, it } from 'vitest'
import type { Template } from '@botgarten/blocks'
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
  repeat,
  show,
  start,
  wait,
} from '../testing/build.ts'
import { nextTick, recordingRobot, type Entry } from '../testing/recording-robot.ts'
import { evaluate, indexProgram, runThread, startThread } from '../index.ts'

/** Runs rows under a start block; what was told, without the end's stop and silence. */
function run(rows: readonly Template[], ticks = 100, outputs = 2) {
  const recording = recordingRobot(outputs)
  const index = indexProgram(programOf([start, ...rows]))
  const thread = startThread(index)
  while (!thread.ended && recording.tick < ticks) {
    runThread(thread, index, recording.context)
    nextTick(recording)
  }
  const log: readonly Entry[] = thread.ended ? recording.log.slice(0, -2) : recording.log
  return { log, thread, endedIn: recording.tick - 1, whole: recording.log }
}

const shown = (rows: readonly Template[]) =>
  run(rows).log.flatMap(([, verb, , , text]) => (verb === 'display' ? [text] : []))

const lampsIn = (rows: readonly Template[]) =>
  run(rows).log.flatMap(([tick, verb, facts]) => (verb === 'led' ? [[tick, facts]] : []))

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

describe('rules 15 and 16: the network', () => {
  const eye = (port: string) => block('ai_nn_input_node_ultrasonic', { INPUTNODE: `ULTRASONIC_PORT_${port}` })
  const motor = (port: string) => block('ai_nn_output_node', { OUTPUTNODE: `MOTORPORT_${port}` })
  const led = (value: string) => block('ai_nn_output_node_led', { OUTPUTNODE: value })
  const word = (text: string) => block('ai_nn_output_node_text', { OUTPUTNODE: text })
  const sound = block('ai_nn_output_node_sound')
  const channel = (value: string) =>
    block('ai_nn_input_node_coloursensor_rgb_channel', { COLOUR: value, SENSORPORT: '1' })

  /** The brain gives each output of `levels`. */
  function runNet(
    outputs: readonly Template[],
    levels: readonly number[],
    inputs: readonly (Template | null)[] = [eye('2')],
  ) {
    const recording = recordingRobot()
    const thought: (readonly number[])[] = []
    const think = (_id: string, values: readonly number[]) => {
      thought.push([...values])
      return levels
    }
    const index = indexProgram(programOf([start, net(inputs, outputs)]))
    const thread = startThread(index)
    for (let k = 0; k < 3; k++) nextTick(recording)
    runThread(thread, index, { ...recording.context, think })
    return { log: recording.log.slice(0, -2).map(([, ...told]) => told), thought, thread }
  }

  it('reads its filled rows from the top: tick 3 gives 21 cm', () => {
    expect(runNet([], [], [eye('2'), null, eye('3')]).thought).toEqual([[21, 21]])
  })

  it('distances count up to 100, channels 0..255 are 0..100, a colour is 100 or 0', () => {
    const seen = (value: string) =>
      block('ai_nn_input_node_coloursensor_color', { COLOUR: value, SENSORPORT: '1' })
    const light = block('ai_nn_input_node_coloursensor_light', { SENSORPORT: '1' })
    const { thought } = runNet([], [], [channel('#0000ff'), seen('#b30006'), seen('#FFFFFF'), light])
    expect(thought).toEqual([[100, 100, 0, 9]])
    const recording = recordingRobot()
    for (let k = 0; k < 30; k++) nextTick(recording)
    const index = indexProgram(programOf([eye('2')]))
    expect(evaluate(index, 'ai_nn_input_node_ultrasonic', recording.context)).toBe(100)
  })

  it('motors are cut to −100..100, each gets its own level', () => {
    expect(runNet([motor('C'), motor('B')], [150, -3]).log).toEqual([
      ['motor', 'C', 100],
      ['motor', 'B', -3],
    ])
  })

  it('of several lamps the highest above 0 wins, of equals the upper one; none above 0 is off', () => {
    const lamps = [led('#00642E'), led('#F7D118'), led('#B30006')]
    expect(runNet(lamps, [1, 7, 3]).log).toEqual([['led', 'orange']])
    expect(runNet(lamps, [5, 2, 5]).log).toEqual([['led', 'green']])
    expect(runNet(lamps, [0, -1, 0]).log).toEqual([['led', null]])
  })

  it('each word has its own row; one that is not above 0 shows the sign for nothing', () => {
    expect(runNet([word('rot'), motor('B'), word('blau')], [3, 1, 0]).log).toEqual([
      ['motor', 'B', 1],
      ['display', 0, 0, 'rot'],
      ['display', 1, 0, '∅'],
    ])
  })

  it('a tone is value × 5 Hz, the highest sounds, none is silence', () => {
    expect(runNet([sound, sound], [20, 60]).log).toEqual([['tone', 300, null]])
    expect(runNet([sound], [0]).log).toEqual([['tone', 0, null]])
  })

  it('a net of 1,200 inputs is read over two ticks', () => {
    const { thought, thread } = runNet(
      [motor('B')],
      [1],
      Array.from({ length: 1200 }, () => eye('2')),
    )
    expect(thought).toEqual([])
    expect(thread.ended).toBe(false)
    const { log } = run(
      [
        net(
          Array.from({ length: 1200 }, () => eye('2')),
          [motor('B')],
        ),
      ],
      5,
      1,
    )
    expect(log.map(([tick, verb]) => [tick, verb])).toEqual([
      [1, 'think'],
      [1, 'motor'],
    ])
  })
})

describe('rules 17 and 18: failing and ending', () => {
  it('a gap, a sensor that is not there and an unknown block are named at the block', () => {
    const problem = (...rows: Template[]) => run(rows).thread.problem
    expect(problem(block('robControls_wait_time'))).toEqual({
      block: 'robControls_wait_time',
      problem: 'problem.missingValue',
      facts: { input: 'WAIT' },
      stops: true,
    })
    expect(problem(show(distance('4')))).toMatchObject({
      block: 'robSensors_ultrasonic_getSample',
      problem: 'problem.nothingToRead',
    })
    expect(problem(block('robControls_ai'))).toMatchObject({ problem: 'problem.unknownBlock' })
    expect(problem(number(1))).toMatchObject({ block: 'math_number', problem: 'problem.wrongKind' })
  })

  it('the end stops the motors and silences the tone, once', () => {
    const recording = recordingRobot()
    const index = indexProgram(programOf([start, lamp('RED')]))
    const thread = startThread(index)
    for (let k = 0; k < 3; k++) {
      runThread(thread, index, recording.context)
      nextTick(recording)
    }
    expect(recording.log).toEqual([
      [0, 'led', 'red'],
      [0, 'stop'],
      [0, 'tone', 0, null],
    ])
    expect(thread).toMatchObject({ ended: true, lit: null, frames: [] })
  })
})

describe('rule 19: stepping from block to block', () => {
  it('lights each statement block before it is carried out', () => {
    const recording = recordingRobot()
    const index = indexProgram(programOf([start, lamp('RED'), wait(20), lamp('GREEN')]))
    const thread = startThread(index)
    const steps: unknown[] = []
    while (!thread.ended) {
      const over = runThread(thread, index, recording.context, true)
      steps.push([recording.tick, thread.lit, recording.log.length])
      if (over) nextTick(recording)
    }
    expect(steps).toEqual([
      [0, 'actions_bricklight_on_ev3', 0],
      [0, 'robControls_wait_time', 1],
      [0, 'robControls_wait_time', 1],
      [1, 'robControls_wait_time', 1],
      [2, 'actions_bricklight_on_ev3#2', 1],
      [2, null, 4],
    ])
  })

  it('has nothing more to do in a tick that is over', () => {
    const recording = recordingRobot()
    const index = indexProgram(programOf([start, forever(lamp('RED'))]))
    const thread = startThread(index)
    expect([1, 2, 3].map(() => runThread(thread, index, recording.context))).toEqual([true, true, true])
    expect(recording.log).toHaveLength(1)
  })
})

describe('rule 20: a thread is data', () => {
  it('ends quietly where its block is no longer in the program', () => {
    const recording = recordingRobot()
    const index = indexProgram(programOf([start, forever(lamp('RED'))]))
    const thread = startThread(index)
    runThread(thread, index, recording.context)
    nextTick(recording)
    runThread(thread, indexProgram(programOf([start, wait(500)])), recording.context)
    expect(thread).toMatchObject({ ended: true, problem: null })
  })

  it('two robots may run one program', () => {
    const index = indexProgram(programOf([start, repeat(number(3), lamp('RED'))]))
    const robots = [recordingRobot(), recordingRobot()]
    const threads = robots.map(() => startThread(index))
    for (let k = 0; k < 4; k++) {
      robots.forEach((recording, robot) => {
        runThread(threads[robot]!, index, recording.context)
        nextTick(recording)
      })
    }
    expect(robots[0]?.log).toEqual(robots[1]?.log)
    expect(robots[0]?.log).toEqual(run([repeat(number(3), lamp('RED'))]).whole)
  })
})

describe('the value of a block while nothing runs', () => {
  it('is what the block would give now', () => {
    const index = indexProgram(programOf([start, show(calculate('ADD', distance(), number(0.5)))]))
    const recording = recordingRobot()
    nextTick(recording)
    expect(evaluate(index, 'math_arithmetic', recording.context)).toBe(7.5)
    expect(recording.log).toEqual([])
  })

  it('is null for statement blocks, unknown ids and blocks that cannot go on', () => {
    const index = indexProgram(programOf([start, show(distance('4'))]))
    const { context } = recordingRobot()
    for (const id of ['robActions_display_text', 'nowhere', 'robSensors_ultrasonic_getSample'])
      expect(evaluate(index, id, context)).toBeNull()
  })

  it('is there for a layer of any size, and for one that lies about', () => {
    const eye = block('ai_nn_input_node_ultrasonic', { INPUTNODE: 'ULTRASONIC_PORT_2' })
    const big = net(
      Array.from({ length: 3000 }, () => eye),
      [],
    )
    const index = indexProgram(programOf([big]))
    expect(evaluate(index, 'ai_easy_list', recordingRobot().context)).toHaveLength(3000)
  })
})
