import { paintFloor, type Floor, type World } from '@botgarten/simulation'

const substitutes = new WeakSet<Floor>()

/** White, with its areas and lines, in place of a picture that could not be read: no program runs on it. */
export function substituteFor(world: Pick<World, 'size' | 'floor' | 'areas' | 'lines'>): Floor {
  const floor = paintFloor({ ...world, floor: { colour: '#FFFFFF' } })
  substitutes.add(floor)
  return floor
}

/** Would a robot's sensors see white where the child sees a picture? */
export const isSubstitute = (floor: Floor): boolean => substitutes.has(floor)
