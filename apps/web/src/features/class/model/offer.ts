import { cardProject } from '@botgarten/content/document'
import { parseProject, type Project } from '@botgarten/programs/project'
import * as v from 'valibot'
import { loadCard, placeOf } from '#content/cards.ts'
import { shownName, titleOf } from '#content/names.ts'
import { nameOfCopy } from '#storage/messages.ts'
import { add, freshId, list } from '#storage/projects.ts'
import { read, type Ask } from '#storage/ask.ts'
import type { Handout } from './pupil.ts'

const document = v.object({ project: v.unknown() })

async function startOf(card: string): Promise<Project | null> {
  const loaded = await loadCard(card)
  return loaded && cardProject(loaded.world, loaded.card, loaded.start, loaded.card.id)
}

/** What the teacher has sent, read as carefully as a stranger's file; null where it cannot be had. */
async function fetchOffer(ask: Ask, { id, card }: Handout): Promise<Project | null> {
  const found = read(document, await ask('GET', `/me/handouts/${id}`))
  if (!found) return null
  if (found.project === null) return card === null ? null : startOf(card)
  try {
    return parseProject(found.project)
  } catch (cause) {
    console.warn('A program from the teacher cannot be read.', cause)
    return null
  }
}

/**
 * Puts a program that the teacher has sent on this device as a project of its own: everything else stays as it is.
 * @returns where it is; `away`: it does not come · `notKept`: the device cannot save it
 */
export async function takeOffer(
  ask: Ask,
  handout: Handout,
): Promise<{ readonly card: string; readonly id: string } | 'away' | 'notKept'> {
  const offered = await fetchOffer(ask, handout)
  if (!offered) return 'away'
  const place = placeOf(offered)
  const { projects } = await list()
  const names = projects.map(shownName)
  const own = shownName({ project: offered })
  // A card's own work is called like the card, whether it is there yet or not.
  const isTaken = names.includes(own) || own === titleOf(place)
  const project = { ...offered, name: isTaken ? nameOfCopy(own, names) : own }
  const id = freshId(place)
  const error = await add([{ id, project, changed: Date.now() }])
  return error ? 'notKept' : { card: place, id }
}
