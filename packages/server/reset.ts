import { randomBytes } from 'node:crypto'
import { existsSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import type { Accounts } from '@botgarten/classroom'
import { codeWords } from '@botgarten/content/codes'

/** Four words of 1,024: 40 bits, and the sign-in is throttled. */
const words = 4

/** A password that can be read aloud. */
function newPassword(): string {
  const list = codeWords('en')
  const bytes = randomBytes(words * 2)
  return Array.from({ length: words }, (_, at) => list[bytes.readUInt16BE(at * 2) % list.length]!).join('-')
}

/** @returns the new password; null where there is no such teacher */
export async function resetTeacher(
  { reset }: Pick<Accounts, 'reset'>,
  username: string,
): Promise<string | null> {
  const password = newPassword()
  return (await reset({ username, password })) ? password : null
}

/** For who has no console: `reset-teacher.txt` in the data folder holds a name, and `new-password.txt` is the answer. */
export async function resetByFile(
  { accounts }: { accounts: Pick<Accounts, 'reset'> },
  folder: string,
): Promise<void> {
  const asked = join(folder, 'reset-teacher.txt')
  if (!existsSync(asked)) return
  const username = readFileSync(asked, 'utf8').trim()
  const password = await resetTeacher(accounts, username)
  const answer = password === null ? `There is no teacher called ${username}.` : password
  writeFileSync(join(folder, 'new-password.txt'), `${answer}\n`, { mode: 0o600 })
  rmSync(asked)
}
