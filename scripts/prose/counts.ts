// Compares the phrases of words.json in each file with the committed counts, which may only fall.
import type { Match } from './words.ts'

/** Number of matches by path; a file without any is not listed. */
export type Counts = { readonly [path: string]: number }

export interface Found {
  readonly path: string
  readonly matches: readonly Match[]
}

export interface Worse extends Found {
  readonly allowed: number
}

export interface Comparison {
  /** Files with more matches than allowed. */
  readonly worse: readonly Worse[]
  /** Files with fewer matches than allowed, and counted files that no longer exist. */
  readonly better: readonly string[]
  /** Counts after the change. Not to be saved while a file is worse. */
  readonly next: Counts
}

/** @param origins new path → the path from which this file was moved */
export function compare(
  counts: Counts,
  found: readonly Found[],
  origins: ReadonlyMap<string, string> = new Map(),
): Comparison {
  const allowedFor = (path: string) => counts[path] ?? counts[origins.get(path) ?? ''] ?? 0
  const paths = new Set(found.map(({ path }) => path))
  const compared = found.map((file) => ({ ...file, allowed: allowedFor(file.path) }))
  return {
    worse: compared.filter(({ matches, allowed }) => matches.length > allowed),
    better: [
      ...compared.filter(({ matches, allowed }) => matches.length < allowed).map(({ path }) => path),
      ...Object.keys(counts).filter((path) => !paths.has(path)),
    ],
    next: sorted(compared.map(({ path, matches }) => [path, matches.length])),
  }
}

const sorted = (entries: readonly (readonly [string, number])[]): Counts =>
  Object.fromEntries(
    entries.filter(([, count]) => count > 0).sort(([one], [other]) => (one < other ? -1 : 1)),
  )

/** Files with matches that are not counted yet: new ones, and moved ones under their new path. */
export const uncounted = (counts: Counts, found: readonly Found[]): string[] =>
  found.filter(({ path, matches }) => matches.length > 0 && !(path in counts)).map(({ path }) => path)

export const gone = (counts: Counts, found: readonly Found[]): string[] => {
  const paths = new Set(found.map(({ path }) => path))
  return Object.keys(counts).filter((path) => !paths.has(path))
}

/**
 * The matches on lines that the committed text does not have; all of them if there are none on such lines.
 * @param before the committed text, undefined for a new file
 */
export function likelyNew(matches: readonly Match[], text: string, before = ''): readonly Match[] {
  const known = new Set(before.split('\n'))
  const lines = text.split('\n')
  const added = matches.filter(({ line }) => !known.has(lines[line - 1] ?? ''))
  return added.length > 0 ? added : matches
}

export const toJson = (counts: Counts): string => `${JSON.stringify(counts, null, 2)}\n`
