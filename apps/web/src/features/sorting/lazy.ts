// Ways into the playground and what it opens with; the floor that its Bo drives on.
import { loadWorld } from '#content/cards.ts'
import { sortingProject } from '#content/new-project.ts'
import { keepNew } from '#lab/keep-new.ts'
import { m } from '#words/message.ts'
import { createRover, type Rover } from './model/rover.ts'

export { linksFor, openForSorting } from './links.ts'
export { default as Collected } from './view/Collected.svelte'
export { default as Ground } from './view/Floor.svelte'

/** Bo on the floor of coloured tiles. */
export const newRover = async (seed: number): Promise<Rover> => createRover(await loadWorld('tiles'), seed)

/** An empty project of this playground. @returns its id; null if the device cannot save it */
export async function newSorting(): Promise<string | null> {
  const project = await sortingProject()
  return (await keepNew({ ...project, name: m['sorting.newName']() }))?.id ?? null
}
