// What reads Open Roberta's files: only one who has such a file waits for it.
import { loadFreeLab } from '#content/cards.ts'
import type { Project } from '@botgarten/programs'
import { projectFrom } from '@botgarten/programs/open-roberta'

/** An Open Roberta file as a project in the world of the free lab. @throws {ProjectError} and nothing else of the file's */
export async function projectOfFile(text: string, name: string): Promise<Project> {
  const { world } = await loadFreeLab()
  return projectFrom(text, name.replace(/\.xml$/i, '').slice(0, 100), world)
}
