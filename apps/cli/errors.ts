import { message, type Facts, type Key } from './words.ts'

/** What is said in one sentence, in the language of the call. */
class Refusal extends Error {
  constructor(key: Key, facts?: Facts) {
    super(message(key, facts))
  }
}

/** The call itself is wrong: exit 2. */
export class CallError extends Refusal {}

/** A file is missing or wrong: exit 1. */
export class FileError extends Refusal {}

/** Why the system did not read or write a file. */
export function causeOf(error: unknown): string {
  const { code = '', message: raw } = error as NodeJS.ErrnoException
  const key = `cause.${code}`
  return isCause(key) ? message(key) : message('cause.other', { message: raw })
}

const causes = ['ENOENT', 'EACCES', 'EPERM', 'EISDIR', 'ENOTDIR', 'EEXIST', 'EROFS', 'ENOSPC'] as const
const isCause = (key: string): key is `cause.${(typeof causes)[number]}` =>
  causes.some((code) => key === `cause.${code}`)
