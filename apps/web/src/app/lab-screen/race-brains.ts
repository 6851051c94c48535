import { goto } from '$app/navigation'
import { resolve } from '$app/paths'
import type { LabSession } from '#lab/session.svelte.ts'

/** To the race of four brains, where this project drives in its lane. */
export async function raceBrains(session: LabSession): Promise<void> {
  const { autosave } = session
  autosave.changed(() => session.project)
  await autosave.flush()
  await goto(resolve(`/race?brains=garden&p=${encodeURIComponent(autosave.id)}`))
}
