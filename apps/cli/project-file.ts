import { basename, extname } from 'node:path'
import { content } from '@botgarten/content/files'
import { parseProject, ProjectError, type Project } from '@botgarten/programs'
import { projectFrom } from '@botgarten/programs/open-roberta'
import { FileError } from './errors.ts'
import { readText } from './files.ts'
import { message, problemMessage } from './words.ts'

/** In megabytes: no file that can be opened is larger. */
const tooLarge = 20

/** A project by its file's ending: `.xml` is Open Roberta's, which drives in the free lab's world. @throws {FileError} */
export function readProjectFile(path: string): Project {
  const text = readText(path, tooLarge)
  try {
    return isOpenRoberta(path)
      ? projectFrom(text, basename(path).slice(0, -'.xml'.length), content.freeLab().world)
      : parseProject(text)
  } catch (error) {
    if (!(error instanceof ProjectError)) throw error
    const kind = isOpenRoberta(path) ? 'file.noProgram' : 'file.noProject'
    throw new FileError(kind, { path, why: whyOf(error) })
  }
}

const shorten = (text: string) => (text.length > 160 ? `${text.slice(0, 160)}…` : text)

/** Who builds files by hand is also told which part of it is wrong. */
function whyOf({ reason, facts, message: detail }: ProjectError): string {
  const sentence = problemMessage(reason, facts)
  const isVague = reason === 'notAProject' || reason === 'notOpenRoberta'
  return isVague ? message('project.detail', { sentence, detail: shorten(detail) }) : sentence
}

export const isOpenRoberta = (path: string): boolean => extname(path).toLowerCase() === '.xml'
