import { existsSync } from 'node:fs'
import { join } from 'node:path'
import { openPostgres, openSqlite, type Database } from '@botgarten/classroom'
import { causeIn } from '@botgarten/server'
import { FileError } from './errors.ts'

/** @throws {FileError} if there is no database, or it cannot be opened, for example on a read-only disk */
function open(folder: string): Database {
  const file = join(folder, 'botgarten.db')
  if (!existsSync(file)) throw new FileError('serve.noData', { path: folder })
  try {
    return openSqlite(file)
  } catch (error) {
    throw new FileError('serve.noDatabase', { why: causeIn(error) })
  }
}

/**
 * Opens the database of a class server for `work`, also while the server uses it.
 * @param address `postgres://…` if the database is not a file in the folder
 */
export async function withDatabase<T>(
  folder: string,
  work: (database: Database) => Promise<T>,
  address?: string,
): Promise<T> {
  const database = address === undefined ? open(folder) : openPostgres(address)
  try {
    return await work(database)
  } finally {
    await database.close()
  }
}
