import { open } from '#storage/projects.ts'
import type { OpenedForSorting } from './shelf.ts'

/** A kept project, read as carefully as a stranger's file; null where there is none, or none that can be read. */
export async function openForSorting(id: string): Promise<OpenedForSorting | null> {
  const kept = await open(id)
  return kept && { id, revision: kept.revision, project: kept.project }
}
