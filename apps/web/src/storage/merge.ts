import { writeProject, type Project } from '@botgarten/programs'
import { DAYS_KEPT, type Binned, type ToBin } from './bin.ts'
import { DAY, type PackedBinned, type ReadHome } from './home-file.ts'
import type { Listed } from './projects.ts'

/** What becomes of the projects of a home file on a device that has some already. */
export interface Merge {
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
