// What a robot learns by trying with its own sensors. It comes when a program first tries so.
import type { LabSession } from '#lab/session.svelte.ts'
import type { SetFields } from './model/night.svelte.ts'
import { Senses } from './senses.svelte.ts'

/** Shows what a session's robot learns. `setFields`: edges are fields of its blocks. Returns how to close it. */
export function hold(session: LabSession, setFields: SetFields): () => void {
  const senses = new Senses(session, setFields)
  const close = senses.open()
  session.senses = senses
  return () => {
    close()
    if (session.senses === senses) session.senses = null
  }
}
