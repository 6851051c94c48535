import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { nextTick, recordingRobot } from '../testing/recording-robot.ts'
import { randomPrograms } from '../testing/random-programs.ts'
import { Twin } from '../testing/twin.ts'
import type { Program, Thread } from '../types.ts'
import { indexProgram, runThread, startThread } from '../index.ts'

const ticks = 120

type OneTick = (thread: Thread) => Thread

/** The whole run: what the robot was told, and how the thread stood after every tick. */
function record(program: Program, drive: (tick: OneTick, thread: Thread) => Thread, untilNextBlock = false) {
  const recording = recordingRobot()
  const index = indexProgram(program)
  const states: unknown[] = []
  let thread = startThread(index)
  for (let k = 0; k < ticks; k++) {
    thread = drive((running) => {
      while (!runThread(running, index, recording.context, untilNextBlock));
      return running
    }, thread)
    const { lit, ended, problem } = thread
    states.push([lit, ended, problem?.block, problem?.problem])
    nextTick(recording)
  }
  return { log: recording.log, states, thread }
}

const plainly = (program: Program) => record(program, (tick, thread) => tick(thread))

function recordTwin(program: Program) {
  const recording = recordingRobot()
  const twin = new Twin(program.stacks[0]?.blocks ?? [], recording.context)
  const states: unknown[] = []
  for (let k = 0; k < ticks; k++) {
    twin.tick()
    states.push([twin.lit, twin.ended, twin.problem?.block, twin.problem?.problem])
    nextTick(recording)
  }
  return { log: recording.log, states }
}

describe('random programs', () => {
  it('do in every tick what the slow twin does (rules 2 to 18)', () => {
    fc.assert(
      fc.property(randomPrograms, (program) => {
        const { log, states } = plainly(program)
        expect({ log, states }).toEqual(recordTwin(program))
      }),
      { numRuns: 600 },
    )
  })

  it('run the same when stepped from block to block (rule 19)', () => {
    fc.assert(
      fc.property(randomPrograms, (program) => {
        expect(record(program, (tick, thread) => tick(thread), true)).toEqual(plainly(program))
      }),
      { numRuns: 200 },
    )
  })

  it('go on the same from a copy of the thread, taken after every tick (rule 20)', () => {
    fc.assert(
      fc.property(randomPrograms, (program) => {
        expect(record(program, (tick, thread) => tick(structuredClone(thread)))).toEqual(plainly(program))
      }),
      { numRuns: 200 },
    )
  })
})

describe('the random programs themselves', () => {
  it('reach every way to end, and programs that go on', () => {
    const endings = new Set<string>()
    for (const program of fc.sample(randomPrograms, { numRuns: 600, seed: 7 })) {
      const { thread } = plainly(program)
      endings.add(thread.problem?.problem ?? (thread.ended ? 'ended' : 'goes on'))
    }
    expect([...endings].sort()).toEqual([
      'ended',
      'goes on',
      'problem.divisionByZero',
      'problem.missingValue',
      'problem.nothingToRead',
      'problem.tooBigNumber',
    ])
  })
})
