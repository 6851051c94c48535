// Codes: https://www.sqlite.org/rescode.html and appendix A of PostgreSQL's manual.
import { expect, test } from 'vitest'
import { refusalOfDatabase } from './errors.ts'

const failed = (code: string) => Object.assign(new Error('It failed.'), { code })
const answerTo = (code: string) => {
  const { status, code: word } = refusalOfDatabase(failed(code))!
  return `${status} ${word}`
}

test.each(['SQLITE_FULL', '53100', 'ENOSPC'])('%s: the disk is full', (code) =>
  expect(answerTo(code)).toBe('507 diskFull'),
)

test.each([
  ...['SQLITE_READONLY', 'SQLITE_READONLY_DBMOVED', 'SQLITE_CANTOPEN', 'SQLITE_IOERR', 'SQLITE_IOERR_WRITE'],
  ...['25006', '58030'],
])('%s: nothing can be written', (code) => expect(answerTo(code)).toBe('503 notWritable'))

test.each(['SQLITE_CORRUPT', 'SQLITE_CORRUPT_VTAB', 'SQLITE_NOTADB', 'XX001', 'XX002'])(
  '%s: the database is broken',
  (code) => expect(answerTo(code)).toBe('503 broken'),
)

test.each([
  ...['SQLITE_BUSY', 'SQLITE_BUSY_SNAPSHOT', 'SQLITE_LOCKED'],
  ...['SQLITE_CONSTRAINT_FOREIGNKEY', 'SQLITE_CONSTRAINT_PRIMARYKEY', 'SQLITE_CONSTRAINT_UNIQUE'],
  ...[
    '23503',
    '23505',
    '53000',
    '53200',
    '53300',
    '53400',
    '40001',
    '40P01',
    '55P03',
    '57014',
    '57P01',
    '57P02',
    '57P03',
  ],
  ...['ECONNREFUSED', 'ECONNRESET', 'EPIPE', 'ETIMEDOUT', 'ENOENT'],
])('%s: a page tries again', (code) => expect(answerTo(code)).toBe('503 busy'))

test.each([
  'Connection terminated unexpectedly',
  'timeout exceeded when trying to connect',
  'Query read timeout',
  'Client has encountered a connection error and is not queryable',
  'Client was closed and is not queryable',
])('“%s” has no code, and a page tries again', (message) =>
  expect(refusalOfDatabase(new Error(message))).toMatchObject({ status: 503, code: 'busy' }),
)

test.each(['SQLITE_ERROR', 'SQLITE_CONSTRAINT_NOTNULL', '42601', 'nothing'])(
  '%s is a fault of ours',
  (code) => expect(refusalOfDatabase(failed(code))).toBeNull(),
)
