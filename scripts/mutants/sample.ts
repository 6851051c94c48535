import { createHash } from 'node:crypto'
import { globSync, readFileSync, statSync } from 'node:fs'
import { join } from 'node:path'
import { isReadable, mutantsOf, type Mutant } from './mutations.ts'
import type { Room } from './rooms.ts'

/** A mutant that no test can find, since the program does the same. */
export interface Equivalent {
  readonly file: string
  readonly was: string
  readonly change: string
  readonly because: string
}

const noCode = /\.(test|d)\.ts$|\/testing\.ts$|\/(generated|testing|reference|node_modules)\//
/** Doors name lazy parts and the owners of workers. */
const views = /\/view\/|\/(feature|lazy|new-worker)\.ts$/

/** The files of a room whose code is changed, relative to the repository. */
export const filesOf = (
  house: string,
  { code, withoutViews }: Pick<Room, 'code' | 'withoutViews'>,
): string[] =>
  code
    .flatMap((path) =>
      statSync(join(house, path)).isFile() ? [path] : globSync(`${path}/**/*.{ts,mjs}`, { cwd: house }),
    )
    .map((path) => path.replaceAll('\\', '/'))
    .filter((path) => !noCode.test(path) && !(withoutViews && views.test(path)))
    .sort()

export const isSame = (one: Omit<Equivalent, 'because'>, other: Omit<Equivalent, 'because'>): boolean =>
  one.file === other.file && one.was === other.was && one.change === other.change

/**
 * So many of a room's mutants, without the equivalent ones. Which ones hangs on the seed and on what each of them changes,
 * so that an edit elsewhere leaves the others in the sample.
 */
export function sampleOf(
  house: string,
  room: Room,
  { count, seed, equivalent }: { count: number; seed: number; equivalent: readonly Equivalent[] },
): { readonly mutants: readonly Mutant[]; readonly among: number } {
  const all = filesOf(house, room).flatMap((file) => mutantsOf(file, readFileSync(join(house, file), 'utf8')))
  const drawn = all
    .map((mutant) => ({ mutant, order: orderOf(mutant, seed) }))
    .toSorted((a, b) => (a.order < b.order ? -1 : 1))
    .map(({ mutant }) => mutant)
  const mutants: Mutant[] = []
  for (const mutant of drawn) {
    if (mutants.length === count) break
    if (!equivalent.some((one) => isSame(one, mutant)) && isReadable(mutant)) mutants.push(mutant)
  }
  return { mutants, among: all.length }
}

const orderOf = ({ file, was, change }: Mutant, seed: number): string =>
  createHash('sha256').update([seed, file, was, change].join('\n')).digest('hex')
