import { load, save } from '#lib/storage/projects.ts'
import { say } from '#lib/words/say.ts'
import { cardProject } from '@botgarten/materials'
import { programOf } from './programs.ts'

/**
 * Lays a card out for a class, with the program that the slide names, whatever was done with it the last time. One project
 * for each such slide is kept: what children keep of the card stays theirs.
 * @returns its key
 */
export async function layOut(card: string, file: string): Promise<string> {
  const id = `slide-${card}-${file}`
  const kept = await load(id)
  if (!kept && file === 'start') return id
  const { card: loaded, program } = await programOf(card, file)
  const project = cardProject(
    loaded.world,
    loaded.card,
    program,
    `${say(`home.${card}`)} · ${say('materials.onSlides')}`,
  )
  await save(id, project, kept?.revision ?? 0)
  return id
}
