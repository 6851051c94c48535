import type { Database } from '../database/database.ts'
import { keyedHash } from '../hashes.ts'

const row = 'key'

/** Does a database belong to this key? A new one does from now on; it holds a mark of the key, never the key. */
export async function isKeyOf({ db }: Pick<Database, 'db'>, secret: Uint8Array): Promise<boolean> {
  const value = keyedHash(secret, 'the key of this database')
  await db
    .insertInto('meta')
    .values({ key: row, value })
    .onConflict((conflict) => conflict.column('key').doNothing())
    .execute()
  const found = await db.selectFrom('meta').select('value').where('key', '=', row).executeTakeFirst()
  return found?.value === value
}
