import type { Project } from '../types.ts'

/**
 * Versions of the project's file. A file says the oldest version whose readers know everything in it, so that what holds
 * no maps is still read everywhere. 1: the first. 2: with `maps`; nothing else is different, and a file of version 1 is
 * one of version 2 that holds no maps.
 */
export const newest = 2

/** What a project is written as. */
export const versionOf = ({ maps = {} }: Pick<Project, 'maps'>): Project['botgarten'] =>
  Object.keys(maps).length > 0 ? 2 : 1
