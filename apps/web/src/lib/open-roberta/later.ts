// What reads and writes Open Roberta's files: only one who has such a file waits for it.
import { loadFreeLab } from '#lib/content/cards.ts'
import { handOut } from '#lib/storage/handout.ts'
import type { Project } from '@botgarten/programs'
import { fileFrom, projectFrom } from '@botgarten/programs/open-roberta'

/** An Open Roberta file as a project in the world of the free lab. @throws {ProjectError} and nothing else of the file's */
export async function projectOfFile(text: string, name: string): Promise<Project> {
  const { world } = await loadFreeLab()
  return projectFrom(text, name.replace(/\.xml$/i, '').slice(0, 100), world)
}

/** Hands a robot's program out as a file for Open Roberta; the first robot's where none is named. */
export const saveOpenRobertaFile = (project: Project, robot = ''): void =>
  handOut(project.name, fileFrom(project, robot), 'xml')
