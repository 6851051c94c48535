import { readFileSync, statSync } from 'node:fs'
import { basename, extname } from 'node:path'
import { parseProject, ProjectError, type Project } from '@botgarten/programs'
import { projectFrom } from '@botgarten/programs/open-roberta'
import { freeWorld } from './content.ts'
import { FileError } from './errors.ts'

/** No file that can be opened is larger. */
const mostBytes = 20_000_000

/** A project by its file's ending: `.xml` is Open Roberta's, which drives in the free lab's world. @throws {FileError} */
export function readProjectFile(path: string): Project {
  try {
    if (statSync(path).size > mostBytes) throw new ProjectError('tooBig', 'It is too big.')
    const text = readFileSync(path, 'utf8')
    return isOpenRoberta(path)
      ? projectFrom(text, basename(path).slice(0, -'.xml'.length), freeWorld())
      : parseProject(text)
  } catch (error) {
    if (error instanceof ProjectError)
      throw new FileError(`"${path}" is not a ${kindOf(path)} that can be opened: ${error.message}`)
    throw new FileError(`"${path}" cannot be read: ${(error as Error).message}`)
  }
}

export const isOpenRoberta = (path: string): boolean => extname(path).toLowerCase() === '.xml'

const kindOf = (path: string) => (isOpenRoberta(path) ? 'program of Open Roberta' : 'project')
