import SqliteFile from 'better-sqlite3'
import { codeOf } from './errors.ts'

const broken = new Set(['SQLITE_CORRUPT', 'SQLITE_NOTADB'])
const isBroken = (error: unknown) => broken.has(codeOf(error).split('_').slice(0, 2).join('_'))

/**
 * Is a file a database without damage? Reads all of it.
 * @throws SqliteError where it cannot be opened or is in use, which says nothing of the file itself
 */
export function isSound(file: string): boolean {
  const sqlite = new SqliteFile(file, { fileMustExist: true })
  try {
    return sqlite.pragma('quick_check', { simple: true }) === 'ok'
  } catch (error) {
    if (isBroken(error)) return false
    throw error
  } finally {
    sqlite.close()
  }
}
