// Ways to get weights that are asked for by a click: examples that are shown, and practice.
import type { LabSession } from '#lab/session.svelte.ts'
import { Training, type Way } from './training.svelte.ts'

export type { Training, Way }

/** What a session's networks are shown and practise. It is there from the first question on. */
export function training(session: LabSession, way: Way): Training {
  const held = session.training ?? new Training(session)
  held.way = way
  session.training = held
  return held
}
