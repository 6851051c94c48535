import type { Ports } from '../ports.ts'
import { deleteUnheld } from '../live/handouts-store.ts'
import { settleAll } from '../questionnaires/nightly.ts'
import { recount } from '../projects/assets-store.ts'
import { allClasses, clearAway } from './clearing-store.ts'
import { reserveTombstone } from './deleting-store.ts'
import { deleteForGood, finishDeletions, withRoom } from './deleting.ts'
import { countDay, endingNow } from './ending-store.ts'

async function endClass(ports: Ports, id: string) {
  await deleteForGood(ports, { kind: 'class', id })
  ports.live.end(id, 'everybody', 'ended')
}

/** What the server does once a day: counts the day, ends classes whose time has come, clears away what is over. */
export async function everyNight(ports: Ports): Promise<void> {
  const { db } = ports.database
  const now = ports.now()
  await finishDeletions(ports)
  await withRoom(ports, () => countDay(ports))
  for (const id of await endingNow(ports)) await endClass(ports, id)
  await settleAll(ports)
  await clearAway(db, now, ports.day(0))
  await deleteUnheld(db)
  if (ports.database.kind === 'postgres') await reserveTombstone(db)
  for (const id of await allClasses(db)) await db.transaction().execute((inside) => recount(inside, id))
}
