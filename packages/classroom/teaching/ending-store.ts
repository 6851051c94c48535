import type { Db } from '../database/database.ts'
import type { ClassRow } from '../database/tables.ts'
import type { Ports } from '../ports.ts'
import { changeClass } from './classes-store.ts'

/** A class ends by itself only this many days after its teacher was shown that it will, counted in days the server ran. */
const warning = 14
const counter = 'days'

/** How many different days this server has run on. */
async function daysRun(db: Db): Promise<number> {
  const row = await db.selectFrom('meta').select('value').where('key', '=', counter).executeTakeFirst()
  return row ? Number(row.value.split(' ')[0]) : 0
}

/** Counts today once, however often it is asked. A clock that was set back counts nothing. */
export async function countDay({ database: { db }, day }: Ports): Promise<void> {
  const row = await db.selectFrom('meta').select('value').where('key', '=', counter).executeTakeFirst()
  const [count = '0', last = ''] = row?.value.split(' ') ?? []
  if (last >= day(0)) return
  const value = `${Number(count) + 1} ${day(0)}`
  await db
    .insertInto('meta')
    .values({ key: counter, value })
    .onConflict((conflict) => conflict.column('key').doUpdateSet({ value }))
    .execute()
}

/** Notes that a teacher is shown the end of a class, where it is near. */
export async function announce(ports: Ports, row: ClassRow): Promise<ClassRow> {
  if (row.announcedDay !== null || row.endsOn > ports.day(warning)) return row
  const announcedDay = await daysRun(ports.database.db)
  await changeClass(ports.database.db, row.id, { announcedDay })
  return { ...row, announcedDay }
}

/** Ids of the classes that end today or should have. */
export async function endingNow({ database: { db }, day }: Ports): Promise<readonly string[]> {
  const rows = await db
    .selectFrom('class')
    .select('id')
    .where('endsOn', '<=', day(0))
    .where('announcedDay', '<=', (await daysRun(db)) - warning)
    .execute()
  return rows.map(({ id }) => id)
}
