// Ways into the playground and what it opens with; the floor that its Bo drives on.
import { loadWorld } from '#content/cards.ts'
import { createRover, type Rover } from './model/rover.ts'

export { linksFor, openForSorting } from './links.ts'
export { default as Collected } from './view/Collected.svelte'
export { default as Ground } from './view/Floor.svelte'

/** Bo on the floor of coloured tiles. */
export const newRover = async (seed: number): Promise<Rover> => createRover(await loadWorld('tiles'), seed)
