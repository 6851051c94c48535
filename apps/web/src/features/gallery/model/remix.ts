import type { Project } from '@botgarten/programs'
import type { Opened } from './api.ts'

/** So many of those before stay with a project. */
const longestChain = 20

/** What a remix begins with: the snapshot, and what it was made from by id and title. No name goes along. */
export function remixOf({ id, title, project }: Pick<Opened, 'id' | 'title' | 'project'>): Project {
  const { progress: _, madeFrom = [], ...snapshot } = project
  return { ...snapshot, madeFrom: [...madeFrom, { id, title }].slice(-longestChain) }
}
