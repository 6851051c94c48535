// Room that a deletion has on a full disk: a file that is made while there is room, and given back when a deletion needs it.
import { existsSync, rmSync, statfsSync, statSync, truncateSync } from 'node:fs'
import { appendFile } from 'node:fs/promises'
import { join } from 'node:path'
import { randomBytes } from 'node:crypto'

/** SQLite's journal at its longest (16 MB), and the largest project with its pictures (5 MB). */
const usualSize = 24_000_000
const piece = 1_000_000

const fileIn = (folder: string) => join(folder, 'reserve')
const sizeIn = (folder: string) => (existsSync(fileIn(folder)) ? statSync(fileIn(folder)).size : 0)

const freeIn = (folder: string) => {
  const { bavail, bsize } = statfsSync(folder)
  return bavail * bsize
}

/** Makes the reserve, or fills it up, where as much again stays free. A disk without that room is unchanged. */
export async function fillReserve(folder: string, size = usualSize): Promise<void> {
  const missing = size - sizeIn(folder)
  if (missing <= 0 || freeIn(folder) < missing + size) return
  // File systems that compress would store zeros in no room at all.
  const bytes = randomBytes(piece)
  for (let more = missing; more > 0; more -= piece)
    await appendFile(fileIn(folder), bytes.subarray(0, more), { mode: 0o600 })
}

/** Gives room back to the disk. @param bytes of the reserve; all of it if left out */
export function useReserve(folder: string, bytes = Infinity): void {
  const rest = sizeIn(folder) - bytes
  if (rest > 0) truncateSync(fileIn(folder), rest)
  else rmSync(fileIn(folder), { force: true })
}
