// Ways into the playground and what it opens with; the floor that its Bo drives on.
import { loadWorld } from '#content/cards.ts'
import { createRover, type Rover } from './readings/rover.ts'

export { doorsOf } from './doors.ts'
export { openForSorting } from './open.ts'
export { default as Ground } from './readings/Ground.svelte'

/** Bo on the floor of coloured tiles. */
export const newRover = async (seed: number): Promise<Rover> => createRover(await loadWorld('tiles'), seed)
