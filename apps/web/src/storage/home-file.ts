import { parseProject, ProjectError, type Project } from '@botgarten/programs'
import * as v from 'valibot'
import { DAYS_KEPT, type Binned } from './bin.ts'
import type { Listed } from './projects.ts'
import { readSettings, type HomeSettings } from './home-settings.ts'

/** A project of the bin on its way: its 30 days go on where they stopped. */
export interface PackedBinned {
  readonly was: string
  readonly changed: number
  /** For how long it was in the bin: as many milliseconds as its days of use have. */
  readonly age: number
  readonly project: Project
}

export const DAY = 86_400_000

/** A home file that was read: what is whole, and how many of its projects are not. */
export interface ReadHome {
  readonly projects: readonly Listed[]
  readonly bin: readonly PackedBinned[]
  readonly settings: HomeSettings
  readonly broken: number
}

export const mostHomeBytes = 100_000_000
const mostProjects = 2000
/** Version 1 had projects only. */
const newest = 2

const longestKey = 300
const key = v.pipe(v.string(), v.nonEmpty(), v.maxLength(longestKey))
const moment = v.pipe(v.number(), v.finite(), v.minValue(0), v.maxValue(8.64e15))
const entry = v.object({ id: key, changed: moment, project: v.unknown() })
const binned = v.object({ was: key, changed: moment, age: moment, project: v.unknown() })
const some = v.pipe(v.array(v.unknown()), v.maxLength(mostProjects))
const schema = v.variant('botgartenHome', [
  v.object({ botgartenHome: v.literal(1), projects: some }),
  v.object({ botgartenHome: v.literal(newest), projects: some, bin: some, settings: v.unknown() }),
])

interface Limits {
  readonly bytes: number
  readonly projects: number
}

/**
 * Everything on the device as files that `readHome` takes back whole: one line of JSON each, and one file wherever one can
 * hold it all. What is in several comes together again, in whatever order they are opened.
 */
export function packHome(
  projects: readonly Listed[],
  bin: readonly Pick<Binned, 'was' | 'changed' | 'project' | 'left'>[],
  settings: HomeSettings,
  most: Limits = { bytes: mostHomeBytes, projects: mostProjects },
): readonly string[] {
  const encoder = new TextEncoder()
  const around = encoder.encode(fileOf([], [], settings)).length
  const entries = [
    ...projects.map(({ id, changed, project }) => ({
      to: 0,
      json: JSON.stringify({ id: keyOf(id), changed, project }),
    })),
    ...bin.map(({ was, changed, project, left }) => ({
      to: 1,
      json: JSON.stringify({ was: keyOf(was), changed, age: (DAYS_KEPT - left) * DAY, project }),
    })),
  ]
  const files: [projects: string[], bin: string[]][] = [[[], []]]
  let bytes = around
  for (const { to, json } of entries) {
    const comma = files.at(-1)![to]!.length > 0 ? 1 : 0
    const more = encoder.encode(json).length + comma
    const full = bytes + more > most.bytes || files.at(-1)![to]!.length >= most.projects
    if (full) files.push([[], []])
    bytes = (full ? around : bytes) + more
    files.at(-1)![to]!.push(json)
  }
  return files.map(([projects, bin], at) => fileOf(projects, bin, at === 0 ? settings : {}))
}

const keyOf = (id: string) => id.slice(0, longestKey) || 'free'

const fileOf = (projects: readonly string[], bin: readonly string[], settings: HomeSettings): string =>
  `{"botgartenHome":${newest},"projects":[${projects.join()}],"bin":[${bin.join()}],"settings":${JSON.stringify(settings)}}`

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
