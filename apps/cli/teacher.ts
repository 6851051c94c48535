import { accountsOn, secretIn, type Database } from '@botgarten/classroom'
import { resetTeacher } from '@botgarten/server'
import { withDatabase } from './class-database.ts'
import type { Command } from './commands.ts'
import { CallError, FileError } from './errors.ts'
import { options } from './options.ts'
import { usualData } from './serve.ts'
import { message } from './words.ts'

const known = { data: { type: 'string' }, database: { type: 'string' } } as const

/** `botgarten teacher reset NAME`: a new password for a teacher who has forgotten theirs; all sessions end. */
export const reset: Command = { options: known, execute: renew }

async function renew(args: string[]): Promise<string> {
  const { values, positionals } = options(args, known)
  const [name, more] = positionals
  if (name === undefined || more !== undefined) throw new CallError('call.oneTeacher')
  const folder = values.data ?? usualData
  const renewIn = async (database: Database) => {
    const password = await resetTeacher(accountsOn(database, secretIn(folder), Date.now), name)
    if (password === null) throw new FileError('serve.noTeacher', { name })
    return message('serve.reset', { name, password })
  }
  return await withDatabase(folder, renewIn, values.database)
}
