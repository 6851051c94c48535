import { closeSync, existsSync, fsyncSync, openSync, readFileSync, writeSync } from 'node:fs'
import { join } from 'node:path'
import * as v from 'valibot'
import type { Tombstone } from '../ports.ts'

// Beside the backups and in none of them: what was deleted after a backup was made stays deleted when that is restored.
const fileIn = (folder: string) => join(folder, 'deleted.jsonl')

const tombstone = v.object({ kind: v.picklist(['class', 'pupil', 'teacher']), id: v.string() })

/** Adds a deletion to the list; it is on the disk when this returns. */
export function bury(folder: string, { kind, id }: Tombstone): void {
  const file = openSync(fileIn(folder), 'a', 0o600)
  try {
    // A line that a cut in power left unfinished is ended first, so that it spoils no other.
    writeSync(file, `\n${JSON.stringify({ kind, id })}\n`)
    fsyncSync(file)
  } finally {
    closeSync(file)
  }
}

function read(line: string): readonly Tombstone[] {
  try {
    return [v.parse(tombstone, JSON.parse(line))]
  } catch {
    return []
  }
}

/** The list as it is in the file; empty before the first deletion. */
export const tombstonesIn = (folder: string): string =>
  existsSync(fileIn(folder)) ? readFileSync(fileIn(folder), 'utf8') : ''

/** The deletions of a list, the oldest first. The deletion of an unfinished line was never executed. */
export const readTombstones = (list: string): readonly Tombstone[] =>
  list
    .split('\n')
    .filter((line) => line !== '')
    .flatMap(read)

/** All deletions of a data folder. */
export const buriedIn = (folder: string): readonly Tombstone[] => readTombstones(tombstonesIn(folder))

/** Adds the deletions of another list that are missing here. */
export function addTombstones(folder: string, list: readonly Tombstone[]): void {
  const known = new Set(buriedIn(folder).map(({ kind, id }) => `${kind} ${id}`))
  for (const one of list) if (!known.has(`${one.kind} ${one.id}`)) bury(folder, one)
}
