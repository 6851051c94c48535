import { existsSync, readdirSync } from 'node:fs'
import { join } from 'node:path'

/** A part of the code with its unit tests. */
export interface Room {
  /** As it is named on the command line: `packages/maps`, `features/debug`, `web/storage`. */
  readonly name: string
  /** Folders and files with the code that is changed. */
  readonly code: readonly string[]
  /** Views are not changed: browser tests hold them. */
  readonly withoutViews: boolean
  /** Folders of tests; those run that import the changed file. */
  readonly tests: readonly string[]
  /** Tests that walk folders: they run each time, since they find the changed file without importing it. */
  readonly walking: readonly string[]
  /** The rooms that it is counted with. */
  readonly group: Group
  /** Mutants drawn by default. */
  readonly sample: number
}

export const groups = {
  /** What must not be lost. */
  saved: { goal: 0.95, sample: 60 },
  other: { goal: 0.8, sample: 25 },
} as const
export type Group = keyof typeof groups

const features = 'apps/web/src/features'
const web = 'apps/web/src'

/** Properties of rooms beyond those that follow from their folders. */
const more: { readonly [name: string]: Partial<Omit<Room, 'name'>> } = {
  'packages/classroom': { group: 'saved' },
  'packages/learning': { walking: ['packages/learning/learners.test.ts'] },
  // These tests start the server in a process of its own, so that they do not import it.
  'packages/server': {
    tests: ['packages/server', 'apps/cli'],
    walking: ['apps/cli/serve.test.ts', 'packages/server/stopping.test.ts', 'packages/server/nodes.test.ts'],
  },
  'web/storage': {
    code: [`${web}/storage`, `${web}/lab/autosave.svelte.ts`],
    // The queue for the class server and the log of a study are tested together with their users.
    tests: [`${web}/storage`, `${web}/lab`, `${features}/class`, `${features}/study`],
    group: 'saved',
  },
}

const roomAt = (name: string, folder: string): Room => {
  const { group = 'other', ...rest } = more[name] ?? {}
  return {
    ...{ name, code: [folder], withoutViews: folder.startsWith(`${features}/`), tests: [folder] },
    ...{ walking: [], group, sample: groups[group].sample, ...rest },
  }
}

/** All rooms: every package, every feature, and of the web storage and lab. */
export function roomsIn(house: string): readonly Room[] {
  const below = (folder: string) =>
    readdirSync(join(house, folder), { withFileTypes: true })
      .filter((entry) => entry.isDirectory())
      .map((entry) => entry.name)
      .sort()
  return [
    ...below('packages')
      .filter((name) => existsSync(join(house, 'packages', name, 'package.json')))
      .map((name) => roomAt(`packages/${name}`, `packages/${name}`)),
    ...below(features).map((name) => roomAt(`features/${name}`, `${features}/${name}`)),
    ...['lab', 'storage'].map((name) => roomAt(`web/${name}`, `${web}/${name}`)),
  ]
}
