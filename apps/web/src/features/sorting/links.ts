import { goto } from '$app/navigation'
import { resolve } from '$app/paths'
import { parseProject, salvageProject, type Project } from '@botgarten/programs/project'
import { sortingProject } from '#content/new-project.ts'
import type { LabSession } from '#lab/session.svelte.ts'
import { moveOldSorting, oldSorting } from '#storage/old-sorting.ts'
import { freshId, load } from '#storage/projects.ts'
import { writtenReadings } from './model/kept.ts'
import type { OpenedForSorting } from './model/store.svelte.ts'

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

/** The project of this id. If there is none, or without an id, the one that the address alone opens. */
export async function openForSorting(
  id: string | null,
): Promise<{ readonly opened: OpenedForSorting; readonly missing: boolean }> {
  await moveOldSorting()
  const kept = await load(id ?? 'sorting')
  if (!kept && id !== null) return { ...(await openForSorting(null)), missing: true }
  // A device that cannot save the earlier work as a project displays it all the same.
  const fresh = await sortingProject(oldSorting() ?? undefined)
  return {
    opened: kept ? readKept(kept, fresh) : { id: 'sorting', revision: 0, project: fresh },
    missing: false,
  }
}

/** One that is damaged stays where it is, and what of it can be opened becomes a project of its own. */
function readKept({ id, revision, project }: OpenedForSorting, fresh: Project): OpenedForSorting {
  try {
    return { id, revision, project: parseProject(project) }
  } catch (cause) {
    console.warn('A kept project cannot be read.', cause)
    const salvaged = salvageProject(project, fresh)?.project ?? fresh
    return { id: freshId('sorting'), revision: 0, project: salvaged }
  }
}
