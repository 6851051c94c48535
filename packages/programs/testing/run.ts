import type { Template } from '@botgarten/blocks'
import { indexProgram, runThread, startThread } from '../index.ts'
import { programOf, start } from './build.ts'
import { nextTick, recordingRobot, type Entry } from './recording-robot.ts'

/** Runs rows under a start block; what was told, without the end's stop and silence. */
export function run(rows: readonly Template[], ticks = 100, outputs = 2) {
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

export const shown = (rows: readonly Template[]) =>
  run(rows).log.flatMap(([, verb, , , text]) => (verb === 'display' ? [text] : []))

export const lampsIn = (rows: readonly Template[]) =>
  run(rows).log.flatMap(([tick, verb, facts]) => (verb === 'led' ? [[tick, facts]] : []))
