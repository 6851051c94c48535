import { deleteUnheld } from '../live/handouts-store.ts'
import type { Ports } from '../ports.ts'
import { recount } from '../projects/space-store.ts'
import { settleAll } from '../questionnaires/nightly.ts'
import { allClasses, clearAway } from './clearing-store.ts'
import { reserveTombstone } from './deleting-store.ts'
import { deleteForGood, finishDeletions, withRoom } from './deleting.ts'
import { endedClasses } from './ending-store.ts'
import { daysNow, noteDay } from './running-days-store.ts'

async function endClass(ports: Ports, id: string) {
  await deleteForGood(ports, { kind: 'class', id })
  ports.live.end(id, 'everybody', 'ended')
}

/**
 * Checks the clock and deletes the classes that have ended. While the clock is doubted nothing is deleted, and their open pages
 * are sent away. Runs before the first answer of a server, and when a day begins.
 * @returns whether the clock is doubted
 */
export async function endClasses(ports: Ports): Promise<boolean> {
  const { db } = ports.database
  await finishDeletions(ports)
  // A clock that jumps in between must not decide with another day.
  const today = ports.day(0)
  const clocked = { db, clock: ports.day }
  // A full disk may take no note of the day. Deleting makes room on it.
  const { doubt } = await withRoom(ports, () => noteDay(clocked)).catch(() => daysNow(clocked))
  if (ports.day(0) !== today) return endClasses(ports)
  for (const id of await endedClasses(db, () => today))
    if (doubt === null) await endClass(ports, id)
    else if (!doubt.denied) ports.live.end(id, 'everybody', 'again')
  return doubt !== null
}

/** The daily work of the server: it ends classes whose time has come and clears away data that is over. */
export async function everyNight(ports: Ports): Promise<void> {
  const { db } = ports.database
  const isDoubted = await endClasses(ports)
  await settleAll(ports)
  if (!isDoubted) await clearAway(db, ports.now(), ports.day(0))
  await deleteUnheld(db)
  if (ports.database.kind === 'postgres') await reserveTombstone(db)
  for (const id of await allClasses(db)) await db.transaction().execute((inside) => recount(inside, id))
}
