import type { Project } from '../types.ts'

/**
 * Versions of the project's file. A file says the oldest version whose readers know everything in it, so that what holds
 * no maps is still read everywhere. 1: the first. 2: with `maps`. 3: with `ownCard`. Nothing else is different: a file of
 * version 1 is one of version 3 that holds neither.
 */
export const newest = 3

/** What a project is written as. */
export function versionOf({ maps = {}, ownCard }: Pick<Project, 'maps' | 'ownCard'>): Project['botgarten'] {
  if (ownCard) return 3
  return Object.keys(maps).length > 0 ? 2 : 1
}
