// What is seen inside a network, asked for by a click: why, its function, its field.
import type { LabSession } from '#lab/session.svelte.ts'
import { Inside, type Page } from './inside.svelte.ts'

export type { Inside }

/** What of the session's network is looked at. It is there from the first question on. */
export function inside(session: LabSession): Inside {
  const held = session.inside ?? new Inside(session)
  session.inside = held
  return held
}

/** Stops the drive, so that there is a moment to ask about, and opens a page on it. */
export function look(session: LabSession, page: Page): void {
  session.lab.pause()
  inside(session).page = page
}
