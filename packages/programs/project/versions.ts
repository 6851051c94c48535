import type { Project } from '../types.ts'

/**
 * Versions of the project's file. A file says the oldest version whose readers know everything in it, so that what holds
 * no maps is still read everywhere. 1: the first. 2: with `maps`. 3: with `ownCard`. 4: with a table among its brains.
 * 5: with `playground`. Nothing else is different: a file of version 1 is one of version 5 that holds none of them.
 */
export const newest = 5

type Parts = Pick<Project, 'maps' | 'ownCard' | 'tables' | 'playground'>

/** What a project is written as. */
export function versionOf({ maps = {}, ownCard, tables = {}, playground }: Parts): Project['botgarten'] {
  if (playground) return 5
  if (Object.keys(tables).length > 0) return 4
  if (ownCard) return 3
  return Object.keys(maps).length > 0 ? 2 : 1
}

/** It learns tables, or loses them, while it is worked on; no file says less than it holds. */
export function withVersion(project: Project): Project {
  const { botgarten, tables, playground } = project
  const fits = playground ? botgarten === 5 : (botgarten === 4) === (tables !== undefined)
  if (fits) return project
  return { ...project, botgarten: versionOf(project) }
}
