import { existsSync, readFileSync } from 'node:fs'
import { join, resolve } from 'node:path'
import { createInterface } from 'node:readline/promises'
import { text } from 'node:stream/consumers'
import {
  backup as backUp,
  isSealed,
  markPhraseShown,
  phraseFrom,
  phraseOf,
  phraseShown,
  restore as putBack,
  type Database,
} from '@botgarten/classroom'
import { CannotServe, causeIn, dayHere, keyFor, lockFolder, prepareDataFolder } from '@botgarten/server'
import { withDatabase } from './class-database.ts'
import type { Command } from './commands.ts'
import { CallError, FileError } from './errors.ts'
import { options, refuseMore } from './options.ts'
import { usualData } from './serve.ts'
import { sayProblem } from './serve-problems.ts'
import { message, type Key } from './words.ts'

const data = { data: { type: 'string' } } as const

/** `botgarten backup FILE`: one encrypted file with all that a class server has, also while it is running. */
export const backup: Command = { options: data, execute: copy }

async function copy(args: string[]): Promise<string> {
  const { values, positionals } = options(args, data)
  const file = oneFile(positionals)
  const folder = resolve(values.data ?? usualData)
  return await withDatabase(folder, async (database) => {
    const secret = keyFor(folder)
    try {
      await backUp({ database, secret, folder, day: dayHere(0) }, file)
    } catch (error) {
      throw new FileError('serve.noBackup', { path: file, why: causeIn(error) })
    }
    return [message('serve.backedUp', { path: file }), await phraseFirst(database, secret)].join('\n')
  })
}

/** The passphrase until it was shown once; after that, the command that shows it. */
async function phraseFirst(database: Database, secret: Uint8Array): Promise<string> {
  if (await phraseShown(database.db)) return message('serve.phraseKnown')
  return await showPhrase(database, secret)
}

async function showPhrase(database: Database, secret: Uint8Array): Promise<string> {
  const phrase = await phraseOf(database, secret)
  await markPhraseShown(database.db)
  return message('serve.phrase', { phrase })
}

/** `botgarten phrase`: shows the passphrase of the backups. */
export const phrase: Command = { options: data, execute: show }

async function show(args: string[]): Promise<string> {
  const { values, positionals } = options(args, data)
  refuseMore(positionals)
  const folder = resolve(values.data ?? usualData)
  return await withDatabase(folder, (database) => showPhrase(database, keyFor(folder)))
}

function oneFile(positionals: readonly string[]): string {
  const [file, more] = positionals
  if (file === undefined || more !== undefined) throw new CallError('call.oneFile')
  return resolve(file)
}

const restoring = { ...data, 'phrase-file': { type: 'string' }, deleted: { type: 'string' } } as const

/** `botgarten restore FILE`: replaces the database by a backup. The database of before stays next to it under another name. */
export const restore: Command = { options: restoring, execute: take }

const refusals: { readonly [kind: string]: Key } = {
  notABackup: 'serve.notABackup',
  phraseNeeded: 'serve.phraseNeeded',
  wrongPhrase: 'serve.wrongPhrase',
  damaged: 'serve.damagedBackup',
  newer: 'serve.newerBackup',
  otherKey: 'serve.otherKeyBackup',
}

async function take(args: string[]): Promise<string> {
  const { values, positionals } = options(args, restoring)
  const file = oneFile(positionals)
  const folder = resolve(values.data ?? usualData)
  const deleted = values.deleted === undefined ? null : existing(resolve(values.deleted))
  const phrase = await phraseFor(file, values['phrase-file'])
  try {
    const free = lockFolder(prepareDataFolder(folder))
    const restored = await putBack(folder, file, { day: dayHere(0), phrase, deleted }).finally(free)
    if (restored.kind !== 'restored') throw new FileError(refusals[restored.kind]!, { path: file })
    return reportOn(file, folder, restored)
  } catch (error) {
    if (error instanceof FileError || error instanceof CannotServe) throw sayProblem(error)
    throw new FileError('serve.noRestore', { path: file, folder, why: causeIn(error) })
  }
}

type Restored = Extract<Awaited<ReturnType<typeof putBack>>, { kind: 'restored' }>

function reportOn(path: string, folder: string, { before, deletionsUnknown, day }: Restored): string {
  const lines = [
    before === null
      ? message('serve.restored', { path })
      : message('serve.restoredInstead', { path, before }),
  ]
  if (deletionsUnknown)
    lines.push(
      day === null ? message('serve.deletionsUnknown') : message('serve.deletionsUnknownSince', { day }),
    )
  if (!existsSync(join(folder, 'https'))) lines.push(message('serve.trustAnew'))
  return lines.join('\n')
}

function existing(path: string): string {
  if (!existsSync(path)) throw new FileError('serve.noList', { path })
  return path
}

/** The passphrase from a file, from the keyboard, or from the standard input; null for a backup without one. */
async function phraseFor(backup: string, file: string | undefined): Promise<string | null> {
  if (!existsSync(backup) || !(await isSealed(backup))) return null
  if (file !== undefined) return phraseFrom(readFileSync(existing(resolve(file)), 'utf8'))
  if (!process.stdin.isTTY) return phraseFrom(await text(process.stdin))
  const asking = createInterface({ input: process.stdin, output: process.stderr })
  const typed = await asking.question(`${message('serve.typePhrase')} `)
  asking.close()
  return phraseFrom(typed)
}
