import { indexProgram } from '../../run/index-program.ts'
import { runThread, startThread } from '../../run/thread.ts'
import type { Program } from '../../types.ts'
import { nextTick, recordingRobot, type Recording } from '../recording-robot.ts'
import { execute } from './statements.ts'
import { WholeTwin } from './twin.ts'
import { valueOf } from './values.ts'

const ticks = 90

/** A letter that comes from outside, in some ticks. */
const letterAt = (tick: number) =>
  tick % 20 === 10
    ? ({ kind: tick % 40 === 10 ? 'call' : 'text', from: 'bo2', text: `letter ${tick}` } as const)
    : null

function recorded(tick: (recording: Recording) => unknown) {
  const recording = recordingRobot()
  const states: unknown[] = []
  for (let k = 0; k < ticks; k++) {
    states.push(tick(recording))
    nextTick(recording)
  }
  return { log: recording.log, states }
}

function interpreted(program: Program) {
  const index = indexProgram(program)
  const thread = startThread(index)
  const run = recorded(({ context, tick }) => {
    const letter = letterAt(tick)
    if (letter) thread.letters.push({ ...letter })
    while (!runThread(thread, index, context));
    // Blocks that are written as text have names in that of their block.
    const at = thread.problem?.block.split('/')[0]
    return [thread.lit, thread.ended, at, thread.problem?.problem]
  })
  const { passed, failed } = thread.assertions
  return {
    ...run,
    variables: thread.scopes[0],
    assertions: {
      passed,
      failed: failed.map(({ text, expected, got }) => [text, expected, got]).slice(0, 100),
    },
    notes: thread.notes.map(({ text }) => text),
  }
}

function told(program: Program) {
  const twin: { now?: WholeTwin } = {}
  const run = recorded((recording) => {
    twin.now ??= new WholeTwin(program, recording.context, { execute, valueOf })
    const letter = letterAt(recording.tick)
    if (letter) twin.now.letters.push({ ...letter })
    twin.now.tick()
    const { lit, ended, problem } = twin.now
    return [lit, ended, problem?.block, problem?.problem]
  })
  const { variables, assertions, notes } = twin.now!
  return {
    ...run,
    variables,
    assertions: { ...assertions, failed: assertions.failed.slice(0, 100) },
    notes: notes.slice(-100),
  }
}

/** Runs a program on the interpreter and on its twin: what the robots were told, how they stood, what they remember. */
export const bothRun = (program: Program) => ({ ours: interpreted(program), twins: told(program) })

/** How a run came out, in a word. */
export function endingOf(program: Program): string {
  const { states } = interpreted(program)
  const [, ended, , problem] = states.at(-1) as [unknown, boolean, unknown, string | undefined]
  return problem ?? (ended ? 'ended' : 'goes on')
}
