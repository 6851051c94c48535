import { Refusal } from '../refusal.ts'

const byCode: { readonly [code: string]: readonly [status: number, code: string] } = {
  SQLITE_FULL: [507, 'diskFull'],
  SQLITE_BUSY: [503, 'busy'],
  SQLITE_LOCKED: [503, 'busy'],
  SQLITE_READONLY: [503, 'notWritable'],
  SQLITE_CANTOPEN: [503, 'notWritable'],
  SQLITE_IOERR: [503, 'notWritable'],
  SQLITE_CORRUPT: [503, 'broken'],
  SQLITE_NOTADB: [503, 'broken'],
  // Two did the same in one moment, or what a row belongs to was just deleted: who asks again hears so.
  SQLITE_CONSTRAINT_FOREIGNKEY: [503, 'busy'],
  SQLITE_CONSTRAINT_PRIMARYKEY: [503, 'busy'],
  SQLITE_CONSTRAINT_UNIQUE: [503, 'busy'],
  '23503': [503, 'busy'],
  '23505': [503, 'busy'],
  // PostgreSQL: disk full, read only, disk failing, damaged, memory full, too many connections, locks, shutting down, starting up.
  '53100': [507, 'diskFull'],
  '25006': [503, 'notWritable'],
  '58030': [503, 'notWritable'],
  XX001: [503, 'broken'],
  XX002: [503, 'broken'],
  '53000': [503, 'busy'],
  '53200': [503, 'busy'],
  '53400': [503, 'busy'],
  '53300': [503, 'busy'],
  '40001': [503, 'busy'],
  '40P01': [503, 'busy'],
  '55P03': [503, 'busy'],
  '57014': [503, 'busy'],
  '57P01': [503, 'busy'],
  '57P02': [503, 'busy'],
  '57P03': [503, 'busy'],
  ECONNREFUSED: [503, 'busy'],
  ECONNRESET: [503, 'busy'],
  EPIPE: [503, 'busy'],
  ETIMEDOUT: [503, 'busy'],
  // The socket of a database that is not running.
  ENOENT: [503, 'busy'],
  ENOSPC: [507, 'diskFull'],
}

const lostConnection =
  /^(Connection terminated|timeout exceeded|Query read timeout|Client has encountered a connection error|Client was closed)/

/** The code of an error of SQLite (`SQLITE_FULL`), PostgreSQL (`53100`) or the system; '' where it has none. */
export const codeOf = (error: unknown): string =>
  error instanceof Error && 'code' in error && typeof error.code === 'string' ? error.code : ''

/** What a failed query means to those who asked; null where it is a fault of ours. Extended codes count as their first two words. */
export function refusalOfDatabase(error: unknown): Refusal | null {
  const code = codeOf(error)
  const known = byCode[code] ?? byCode[code.split('_').slice(0, 2).join('_')]
  if (known) return new Refusal(...known)
  // pg gives a lost connection no code, nor a database that does not answer.
  const lost = error instanceof Error && lostConnection.test(error.message)
  return lost ? new Refusal(503, 'busy') : null
}
