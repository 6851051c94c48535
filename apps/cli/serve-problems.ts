import { CannotServe } from '@botgarten/server'
import { FileError } from './errors.ts'
import type { Key } from './words.ts'

const keys: { readonly [problem: string]: Key } = {
  namedOperator: 'serve.namedOperator',
  usualOperator: 'serve.usualOperator',
  inUse: 'serve.inUse',
  syncedFolder: 'serve.syncedFolder',
  networkFolder: 'serve.networkFolder',
  noFolder: 'serve.noFolder',
  readOnlyFolder: 'serve.readOnlyFolder',
  noDatabase: 'serve.noDatabase',
  newerData: 'serve.newerData',
  noKey: 'serve.noKey',
  otherKey: 'serve.otherKey',
  broken: 'serve.broken',
  brokenWithBackup: 'serve.brokenWithBackup',
}

/** A problem of the server as a sentence; anything else as it is. */
export function sayProblem(error: unknown): unknown {
  if (!(error instanceof CannotServe)) return error
  const key = keys[error.problem]
  return key === undefined ? error : new FileError(key, error.facts)
}
