import type { Project } from '@botgarten/programs'
import { placeOf } from '#content/cards.ts'
import { shownName, titleOf } from '#content/names.ts'
import { nameOfCopy } from '#storage/messages.ts'
import { add, freshId, list } from '#storage/projects.ts'

interface Address {
  readonly card: string
  readonly id: string
}

/** Saves a project on this device as one of its own. @returns where it is; null where the device cannot */
export async function keepNew(project: Project): Promise<Address | null> {
  const { projects } = await list()
  const names = projects.map(shownName)
  const place = placeOf(project)
  const own = shownName({ project })
  // A card's own work is called like the card, whether it is there yet or not.
  const isTaken = names.includes(own) || own === titleOf(place)
  const id = freshId(place)
  const kept = { ...project, name: isTaken ? nameOfCopy(own, names) : own }
  const error = await add([{ id, project: kept, changed: Date.now() }])
  return error ? null : { card: place, id }
}
