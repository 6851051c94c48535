import { existsSync } from 'node:fs'
import { join, resolve } from 'node:path'
import { backup as backUp, openSqlite, restore as putBack } from '@botgarten/classroom'
import { causeIn, lockFolder, prepareDataFolder } from '@botgarten/server'
import type { Command } from './commands.ts'
import { CallError, FileError } from './errors.ts'
import { options } from './options.ts'
import { usualData } from './serve.ts'
import { sayProblem } from './serve-problems.ts'
import { message } from './words.ts'

const known = { data: { type: 'string' } } as const

function fileIn(args: string[]) {
  const { values, positionals } = options(args, known)
  const [file, more] = positionals
  if (file === undefined || more !== undefined) throw new CallError('call.oneFile')
  return { file: resolve(file), folder: resolve(values.data ?? usualData) }
}

/** `botgarten backup FILE`: a copy of the class server's database, also while it is running. */
export const backup: Command = { options: known, execute: copy }

async function copy(args: string[]): Promise<string> {
  const { file, folder } = fileIn(args)
  const source = join(folder, 'botgarten.db')
  if (!existsSync(source)) throw new FileError('serve.noData', { path: folder })
  const database = openSqlite(source)
  try {
    await backUp(database, file)
  } catch (error) {
    throw new FileError('serve.noBackup', { path: file, why: causeIn(error) })
  } finally {
    await database.close()
  }
  return message('serve.backedUp', { path: file })
}

/** `botgarten restore FILE`: a backup in the place of the database, which is kept beside it. */
export const restore: Command = { options: known, execute: take }

async function take(args: string[]): Promise<string> {
  const { file, folder } = fileIn(args)
  try {
    const free = lockFolder(prepareDataFolder(folder))
    const restored = await putBack(folder, file)
    free()
    if (restored.kind === 'notABackup') throw new FileError('serve.notABackup', { path: file })
    return restored.before === null
      ? message('serve.restored', { path: file })
      : message('serve.restoredInstead', { path: file, before: restored.before })
  } catch (error) {
    throw sayProblem(error)
  }
}
