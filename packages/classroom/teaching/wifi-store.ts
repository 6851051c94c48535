import type { Db } from '../database/database.ts'
import type { Wifi } from '../database/tables.ts'

export const wifiOf = (db: Db, teacher: string): Promise<Wifi | undefined> =>
  db.selectFrom('wifi').select(['name', 'password']).where('teacher', '=', teacher).executeTakeFirst()

export async function setWifi(db: Db, teacher: string, wifi: Wifi): Promise<void> {
  await db
    .insertInto('wifi')
    .values({ teacher, ...wifi })
    .onConflict((conflict) => conflict.column('teacher').doUpdateSet(wifi))
    .execute()
}

export async function removeWifi(db: Db, teacher: string): Promise<void> {
  await db.deleteFrom('wifi').where('teacher', '=', teacher).execute()
}
