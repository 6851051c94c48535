import { loadWorld } from '#content/cards.ts'
import { createRover, type Rover } from './rover.ts'

/** The floor that the playground's Bo drives on. */
export const newRover = async (seed: number): Promise<Rover> => createRover(await loadWorld('tiles'), seed)
export { default as Ground } from './Ground.svelte'
