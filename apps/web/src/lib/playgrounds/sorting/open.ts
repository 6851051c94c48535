import { parseProject } from '@botgarten/programs'
import { load } from '#lib/storage/projects.ts'
import type { OpenedForSorting } from './shelf.ts'

/** A kept project, read as carefully as a stranger's file; null where there is none, or none that can be read. */
export async function openForSorting(id: string): Promise<OpenedForSorting | null> {
  const kept = await load(id)
  if (!kept) return null
  try {
    return { id, revision: kept.revision, project: parseProject(kept.project) }
  } catch (cause) {
    console.warn('A kept project cannot be read.', cause)
    return null
  }
}
