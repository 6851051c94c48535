import world from '../../../../../../content/worlds/tiles/world.json'
import { createRover, type Rover } from './rover.ts'

/** The floor that the playground's Bo drives on. */
export const newRover = (seed: number): Rover => createRover(world as unknown as Rover['world'], seed)
export { default as Ground } from './Ground.svelte'
