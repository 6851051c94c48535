import SqliteFile from 'better-sqlite3'
import { codeOf } from '../database/errors.ts'

/**
 * Takes a lock file. The system frees it when the process ends, however that happens: it is an open transaction of
 * SQLite, not a file that a crash leaves behind.
 * @returns gives it free; null where another process holds it
 */
export function openLock(file: string): (() => void) | null {
  const lock = new SqliteFile(file, { timeout: 0 })
  try {
    lock.pragma('journal_mode = DELETE')
    lock.exec('begin exclusive')
    return () => void lock.close()
  } catch (error) {
    lock.close()
    if (codeOf(error).startsWith('SQLITE_BUSY')) return null
    throw error
  }
}
