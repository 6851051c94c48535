import { parseProject, ProjectError, type Project } from '@botgarten/programs'
import * as v from 'valibot'
import type { Kept } from './database.ts'

/** What "take home" writes: everything on the device, in one file. */
interface HomeFile {
  readonly botgartenHome: 1
  readonly projects: readonly { readonly id: string; readonly changed: number; readonly project: Project }[]
}

/** A home file that was read: what is whole, and how many of its projects are not. */
export interface ReadHome {
  readonly projects: readonly Omit<Kept, 'revision'>[]
  readonly broken: number
}

export const mostHomeBytes = 100_000_000
const mostProjects = 2000
const newest = 1

const entry = v.object({
  id: v.pipe(v.string(), v.nonEmpty(), v.maxLength(300)),
  changed: v.pipe(v.number(), v.finite(), v.minValue(0), v.maxValue(8.64e15)),
  project: v.unknown(),
})
const schema = v.object({
  botgartenHome: v.literal(newest),
  projects: v.pipe(v.array(v.unknown()), v.maxLength(mostProjects)),
})

/** One line of JSON with all of them. */
export function writeHome(kept: readonly Kept[]): string {
  const file: HomeFile = {
    botgartenHome: newest,
    projects: kept.map(({ id, changed, project }) => ({ id, changed, project })),
  }
  return JSON.stringify(file)
}

/** Does this data say of itself that it is a home file, of whatever version? */
export const isHome = (data: unknown): data is { readonly botgartenHome: unknown } =>
  typeof data === 'object' && data !== null && 'botgartenHome' in data

/**
 * Reads a home file as carefully as a stranger's. A project in it that is broken does not keep the others out.
 * @throws {ProjectError} and nothing else, where the file as a whole is not one
 */
export function readHome(data: unknown): ReadHome {
  if (isHome(data) && typeof data.botgartenHome === 'number' && data.botgartenHome > newest)
    throw new ProjectError('newerVersion', 'A newer home file.', { version: data.botgartenHome })
  const file = v.safeParse(schema, data)
  if (!file.success) throw new ProjectError('notAProject', 'This is no home file.')
  const projects = file.output.projects.flatMap(readEntry)
  return { projects, broken: file.output.projects.length - projects.length }
}

function readEntry(data: unknown): ReadHome['projects'] {
  const read = v.safeParse(entry, data)
  if (!read.success) return []
  try {
    return [{ ...read.output, project: parseProject(read.output.project) }]
  } catch (cause) {
    if (cause instanceof ProjectError) return []
    throw cause
  }
}
