import { describe, expect, it } from 'vitest'
import type { Template } from '@botgarten/blocks'
import { evaluate, indexProgram, runThread, startThread } from '../index.ts'
import {
  block,
  calculate,
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
import { nextTick, recordingRobot } from '../testing/recording-robot.ts'
import { run } from '../testing/run.ts'

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
  it('lights each statement block before it is executed', () => {
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
