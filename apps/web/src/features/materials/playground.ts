import { titleOf } from '#content/names.ts'
import { load, save } from '#storage/projects.ts'
import { say } from '#words/say.ts'
import { cardProject } from '@botgarten/content/document'
import { programOf } from './programs.ts'

/** A project laid out, by its key. `asStart`: the device keeps nothing, so the lab opens the card with its start program. */
interface LaidOut {
  readonly id: string
  readonly asStart: boolean
}

/**
 * Lays a card out for a class, with the program that the slide names, whatever was done with it the last time. One project
 * for each such slide is kept: what children keep of the card stays theirs.
 */
export async function layOut(card: string, file: string): Promise<LaidOut> {
  const id = `slide-${card}-${file}`
  const kept = await load(id)
  if (!kept && file === 'start') return { id, asStart: false }
  const { card: loaded, program } = await programOf(card, file)
  const name = `${titleOf(card)} · ${say('materials.onSlides')}`
  const project = cardProject(loaded.world, loaded.card, program, name)
  const { kind } = await save(id, project, kept?.revision ?? 0)
  // Another window that shows the same slide has laid out the same.
  return { id, asStart: file !== 'start' && kind !== 'saved' && kind !== 'newer' }
}
