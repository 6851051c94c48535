// For the tests: what `projects.ts` keeps on a device, kept here. Node has nothing to keep projects in.
import type { Project } from '@botgarten/programs'
import type { Kept } from './database.ts'
import type { Saved } from './projects.ts'

const all = new Map<string, Kept>()
let refuses = false

/** A device on which nothing is kept yet, or nothing ever. */
export function freshDevice({ keepsNothing = false } = {}): void {
  all.clear()
  refuses = keepsNothing
}

export const keptKeys = (): readonly string[] => [...all.keys()]

export const load = (id: string): Promise<Kept | null> => Promise.resolve(all.get(id) ?? null)

export function save(id: string, project: Project, basedOn: number): Promise<Saved> {
  if (refuses) return Promise.resolve({ kind: 'refused' })
  if ((all.get(id)?.revision ?? 0) !== basedOn) return Promise.resolve({ kind: 'newer' })
  const revision = basedOn + 1
  all.set(id, { id, project, changed: 0, revision })
  return Promise.resolve({ kind: 'saved', revision })
}
