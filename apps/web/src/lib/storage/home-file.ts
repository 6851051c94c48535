import { parseProject, ProjectError, type Project } from '@botgarten/programs'
import * as v from 'valibot'
import { ageInBin } from './bin.ts'
import type { Kept, Thrown } from './database.ts'
import { readSettings, type HomeSettings } from './home-settings.ts'

/** What "take home" writes: everything on the device, in one file. */
interface HomeFile {
  readonly botgartenHome: 2
  readonly projects: readonly { readonly id: string; readonly changed: number; readonly project: Project }[]
  /** `age`: milliseconds since it was thrown away, when the file was written. */
  readonly bin: readonly Binned[]
  readonly settings: HomeSettings
}

/** A project of the bin on its way: its 30 days go on where they stopped. */
export interface Binned {
  readonly was: string
  readonly changed: number
  readonly age: number
  readonly project: Project
}

/** A home file that was read: what is whole, and how many of its projects are not. */
export interface ReadHome {
  readonly projects: readonly Omit<Kept, 'revision'>[]
  readonly bin: readonly Binned[]
  readonly settings: HomeSettings
  readonly broken: number
}

export const mostHomeBytes = 100_000_000
const mostProjects = 2000
/** Version 1 had projects only. */
const newest = 2

const key = v.pipe(v.string(), v.nonEmpty(), v.maxLength(300))
const moment = v.pipe(v.number(), v.finite(), v.minValue(0), v.maxValue(8.64e15))
const entry = v.object({ id: key, changed: moment, project: v.unknown() })
const binned = v.object({ was: key, changed: moment, age: moment, project: v.unknown() })
const some = v.pipe(v.array(v.unknown()), v.maxLength(mostProjects))
const schema = v.variant('botgartenHome', [
  v.object({ botgartenHome: v.literal(1), projects: some }),
  v.object({ botgartenHome: v.literal(newest), projects: some, bin: some, settings: v.unknown() }),
])

/** One line of JSON with all of them. */
export function writeHome(
  kept: readonly Kept[],
  thrown: readonly Thrown[],
  settings: HomeSettings,
  now: number,
): string {
  const file: HomeFile = {
    botgartenHome: newest,
    projects: kept.map(({ id, changed, project }) => ({ id, changed, project })),
    bin: thrown.map(({ was, changed, project, thrown }) => ({
      ...{ was, changed, project },
      age: ageInBin(thrown, now),
    })),
    settings,
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
  const said = { bin: [], settings: {}, ...file.output }
  const projects = said.projects.flatMap((one) => readEntry(entry, one))
  const bin = said.bin.flatMap((one) => readEntry(binned, one))
  const broken = said.projects.length + said.bin.length - projects.length - bin.length
  return { projects, bin, settings: readSettings(said.settings), broken }
}

function readEntry<Entry extends { readonly project: unknown }>(
  shape: v.GenericSchema<unknown, Entry>,
  data: unknown,
): readonly (Omit<Entry, 'project'> & { readonly project: Project })[] {
  const read = v.safeParse(shape, data)
  if (!read.success) return []
  try {
    return [{ ...read.output, project: parseProject(read.output.project) }]
  } catch (cause) {
    if (cause instanceof ProjectError) return []
    throw cause
  }
}
