import { goto } from '$app/navigation'
import { resolve } from '$app/paths'
import type { LabSession } from '#lab/session.svelte.ts'
import { open } from '#storage/projects.ts'
import { writtenReadings } from './model/kept.ts'
import type { OpenedForSorting } from './model/steps.svelte.ts'

/** A way from the lab into the sorting playground. */
export interface SortingLink {
  /** Message key under `robot`. */
  readonly word: 'sorting' | 'collected'
  readonly go: () => void
}

/** Into the playground of this project, and first to what its robot has collected, if it has. */
export function linksFor(
  session: LabSession,
  readings: readonly (readonly number[])[],
): readonly SortingLink[] {
  const playground = {
    word: 'sorting',
    go: () => void enter(session, session.project.sorting),
  } as const
  if (readings.length === 0) return [playground]
  const collected = () => void enter(session, writtenReadings(readings, session.project.sorting))
  return [{ word: 'collected', go: collected }, playground]
}

/** Keeps the project first: the playground opens what is kept. */
async function enter(session: LabSession, sorting: LabSession['project']['sorting']): Promise<void> {
  const { autosave, project } = session
  autosave.changed(() => (sorting ? { ...project, sorting } : project))
  await autosave.flush()
  if (autosave.state === 'saved') await goto(resolve(`/sorting?p=${encodeURIComponent(autosave.id)}`))
}

/** A kept project, read as carefully as a stranger's file; null where there is none, or none that can be read. */
export async function openForSorting(id: string): Promise<OpenedForSorting | null> {
  const kept = await open(id)
  return kept && { id, revision: kept.revision, project: kept.project }
}
