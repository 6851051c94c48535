import { readdirSync, readFileSync } from 'node:fs'
import { join, relative } from 'node:path'
import { isSealed } from '../hosting/sealed-file.ts'
import { unpacked } from './backups.ts'

/** The bytes of a file, and those of each part of an encrypted backup, a character a byte. */
async function contentsOf(path: string, phrase: string): Promise<readonly string[]> {
  const bytes = readFileSync(path, 'latin1')
  return (await isSealed(path)) ? [bytes, ...Object.values(await unpacked(path, phrase))] : [bytes]
}

/** The files in a folder, also in the folders within, that have one of these words; encrypted backups are opened. */
export async function filesWith(words: readonly string[], folder: string, phrase: string): Promise<string[]> {
  const files = readdirSync(folder, { recursive: true, withFileTypes: true }).filter((one) => one.isFile())
  const found = []
  for (const { parentPath, name } of files) {
    const path = join(parentPath, name)
    const contents = await contentsOf(path, phrase)
    if (contents.some((content) => words.some((word) => content.includes(word))))
      found.push(relative(folder, path))
  }
  return found.toSorted()
}
