import { accessSync, constants, existsSync, rmSync, statfsSync, statSync, writeFileSync } from 'node:fs'
import { dirname, join, resolve } from 'node:path'
import { openLock } from '@botgarten/classroom'
import { brokenIn, isOnNetwork, syncedBy } from '../data-folder.ts'
import { causeIn } from '../problem.ts'
import { fine, wrong } from './finding.ts'

/** Before this day there was no Botgarten: a clock that is before it was never set. */
const earliest = Date.UTC(2026, 0)

const dayOf = (time: number) => new Date(time).toISOString().slice(0, 10)
const aDay = 86_400_000

/**
 * Is the clock right, as far as this machine can know? It never goes back behind what was written already.
 * @param now ms since 1970 @param written when files were written that are certainly older than now
 */
export function examineClock(now: number, written: readonly number[]) {
  const latest = Math.max(earliest, ...written)
  const facts = { now: dayOf(now), latest: dayOf(latest) }
  return now < latest - aDay ? wrong('clock.behind', facts) : fine('clock.fine', facts)
}

const megabyte = 1_000_000
const enough = { lesson: 500, saves: 50 }

/** The folder itself, or the nearest one above it that is there. */
function nearest(folder: string): string {
  const path = resolve(folder)
  return existsSync(path) ? path : nearest(dirname(path))
}

/** Is there room for what a class saves? @param freeSpace MB that are free in a folder */
export function examineDisk(
  folder: string,
  freeSpace = ({ bavail, bsize }: { bavail: number; bsize: number }) => (bavail * bsize) / megabyte,
) {
  const path = nearest(folder)
  const free = Math.floor(freeSpace(statfsSync(path)))
  const facts = { path, free, least: enough.lesson }
  if (free < enough.saves) return wrong('disk.full', facts)
  return free < enough.lesson ? wrong('disk.low', facts) : fine('disk.fine', facts)
}

function errorOfWriting(folder: string): string | null {
  const file = join(folder, `.doctor-${process.pid}`)
  try {
    accessSync(folder, constants.W_OK)
    writeFileSync(file, 'x', { flag: 'wx' })
    return null
  } catch (error) {
    return causeIn(error)
  } finally {
    rmSync(file, { force: true })
  }
}

function isInUse(folder: string): boolean {
  const lock = join(folder, 'server.lock')
  if (!existsSync(lock)) return false
  const free = openLock(lock)
  free?.()
  return free === null
}

/** Is a folder a place for a class server's data? It is left as it is. */
export function examineFolder(folder: string) {
  const path = resolve(folder)
  const by = syncedBy(path)
  if (by !== null) return wrong('folder.synced', { path, by })
  const there = nearest(path)
  if (!statSync(there).isDirectory()) return wrong('folder.isFile', { path: there })
  if (isOnNetwork(there)) return wrong('folder.network', { path })
  const why = errorOfWriting(there)
  if (why === 'ENOSPC') return wrong('folder.noRoom', { path: there })
  if (why !== null) return wrong('folder.readOnly', { path: there, why })
  if (there !== path) return fine('folder.new', { path })
  const aside = brokenIn(path)
  if (aside !== null) return wrong('folder.broken', { path: aside })
  return isInUse(path) ? fine('folder.inUse', { path }) : fine('folder.ready', { path })
}
