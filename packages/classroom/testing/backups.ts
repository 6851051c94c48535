import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { expect } from 'vitest'
import type { Database } from '../database/database.ts'
import { backup, type Stored } from '../hosting/backups.ts'
import { secretIn } from '../hosting/data-folder.ts'
import { phraseOf } from '../hosting/phrase-store.ts'
import { openSealed } from '../hosting/sealed-file.ts'

export const today = '2026-11-24'

/** The server of a data folder. */
export const storedIn = (folder: string, database: Database): Stored => ({
  ...{ database, folder, secret: secretIn(folder), day: today },
})

/** Decrypts and unpacks a backup. @returns each of its files by name, a character a byte */
export async function unpacked(file: string, phrase: string): Promise<Record<string, string>> {
  const into = mkdtempSync(join(tmpdir(), 'botgarten-opened-'))
  try {
    expect(await openSealed(file, phrase, into)).toMatchObject({ kind: 'opened' })
    const names = readdirSync(into).toSorted()
    return Object.fromEntries(names.map((name) => [name, readFileSync(join(into, name), 'latin1')]))
  } finally {
    rmSync(into, { recursive: true })
  }
}

/** Makes a backup of a data folder and opens it. */
export async function openedBackup({ database, folder }: { database: Database; folder: string }) {
  const file = join(folder, 'backups', 'copy.age')
  const stored = storedIn(folder, database)
  await backup(stored, file)
  return await unpacked(file, await phraseOf(database, stored.secret))
}
