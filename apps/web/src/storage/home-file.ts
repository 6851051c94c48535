import { parseProject, ProjectError, type Project, writeProject } from '@botgarten/programs'
import * as v from 'valibot'
import { DAYS_KEPT, type Binned, type ToBin } from './bin.ts'
import type { Listed } from './projects.ts'
import { readSettings, type HomeSettings } from './home-settings.ts'

/** A project of the bin on its way: its 30 days go on where they stopped. */
interface PackedBinned {
  readonly was: string
  readonly changed: number
  /** For how long it was in the bin: as many milliseconds as its days of use have. */
  readonly age: number
  readonly project: Project
}

const DAY = 86_400_000

/** A home file that was read: what is whole, and how many of its projects are not. */
interface ReadHome {
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

/** What becomes of the projects of a home file on a device that has some already. */
interface Merge {
  /** To be written. None of their keys is one of this device. */
  readonly added: readonly Listed[]
  /** How many of the added ones stand beside another project of the same key. */
  readonly copies: number
  /** How many are here already, to the letter. */
  readonly same: number
}

const fingerprint = ({ name: _name, ...project }: Project) => writeProject({ name: '', ...project })

/**
 * Lays projects beside those of this device. What is here stays as it is: a project that differs from the one under its
 * key gets a key and a name of its own.
 * @param keys that are in use besides, by projects that cannot be read
 */
export function mergeHome(
  here: readonly Listed[],
  keys: readonly string[],
  file: ReadHome['projects'],
  name: { fresh(place: string): string; copy(project: Project): string; place(project: Project): string },
): Merge {
  const known = new Set(here.map(({ project }) => fingerprint(project)))
  const taken = new Set([...here.map(({ id }) => id), ...keys])
  const added: Listed[] = []
  let copies = 0
  for (const one of file) {
    const print = fingerprint(one.project)
    if (known.has(print)) continue
    known.add(print)
    const place = name.place(one.project)
    const fits = one.id === place || one.id.startsWith(`${place}-`)
    const clash = taken.has(one.id)
    const id = fits && !clash ? one.id : name.fresh(place)
    taken.add(id)
    copies += clash ? 1 : 0
    added.push({
      ...one,
      id,
      project: clash ? renamed(one.project, name.copy(one.project)) : one.project,
    })
  }
  return { added, copies, same: file.length - added.length }
}

/**
 * What of a file's bin is not in the bin of this device. What was there for 30 days when the file was written is not kept
 * any longer here than there.
 */
export function mergeBin(
  here: readonly Pick<Binned, 'was' | 'project'>[],
  file: readonly PackedBinned[],
  now: number,
): readonly ToBin[] {
  const print = ({ was, project }: Pick<Binned, 'was' | 'project'>) =>
    JSON.stringify([was, project.name, fingerprint(project)])
  const known = new Set(here.map(print))
  return file.flatMap(({ was, changed, project, age }) => {
    const one = print({ was, project })
    if (known.has(one)) return []
    known.add(one)
    const daysIn = Math.min(DAYS_KEPT - 1, Math.floor(age / DAY))
    return [{ was, changed, project, thrown: now - daysIn * DAY, daysIn }]
  })
}

const renamed = (project: Project, name: string): Project => ({ ...project, name })
