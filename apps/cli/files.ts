import { readFileSync, statSync, writeFileSync } from 'node:fs'
import { causeOf, FileError } from './errors.ts'
import { message } from './words.ts'

const megabyte = 1_000_000

/** The bytes of a file. @throws {FileError} also where it has more than so many megabytes */
export function readBytes(path: string, most: number): Buffer {
  try {
    if (statSync(path).size <= most * megabyte) return readFileSync(path)
  } catch (error) {
    throw new FileError('file.unreadable', { path, why: causeOf(error) })
  }
  throw new FileError('file.unreadable', { path, why: message('cause.tooBig', { most }) })
}

/** The text of a file. @throws {FileError} also where it has more than so many megabytes */
export const readText = (path: string, most: number): string => readBytes(path, most).toString('utf8')

/** @throws {FileError} */
export function write(path: string, content: string | Uint8Array): void {
  try {
    writeFileSync(path, content)
  } catch (error) {
    throw new FileError('file.unwritable', { path, why: causeOf(error) })
  }
}
