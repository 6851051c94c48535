import { goto } from '$app/navigation'
import { resolve } from '$app/paths'
import type { LabSession } from '#lab/session.svelte.ts'
import { writtenReadings } from './kept.ts'

/** A way from the lab into the sorting playground. */
export interface SortingDoor {
  /** Message key under `robot`. */
  readonly word: 'sorting' | 'collected'
  readonly go: () => void
}

/** Into the playground of this project, and first to what its robot has collected, if it has. */
export function doorsOf(
  session: LabSession,
  readings: readonly (readonly number[])[],
): readonly SortingDoor[] {
  const playground = {
    word: 'sorting',
    go: () => void open(session, session.project.sorting),
  } as const
  if (readings.length === 0) return [playground]
  const collected = () => void open(session, writtenReadings(readings, session.project.sorting))
  return [{ word: 'collected', go: collected }, playground]
}

/** Keeps the project first: the playground opens what is kept. */
async function open(session: LabSession, sorting: LabSession['project']['sorting']): Promise<void> {
  const { keeper, project } = session
  keeper.changed(() => (sorting ? { ...project, sorting } : project))
  await keeper.flush()
  if (keeper.state === 'saved') await goto(resolve(`/sorting?p=${encodeURIComponent(keeper.id)}`))
}
