import type { Obstacle, Pose } from '@botgarten/simulation'
import { thingName } from '#content/thing-name.ts'
import { m } from '#words/message.ts'

/** What a child calls an obstacle and where it stands. */
export const placed = (thing: Obstacle, { x, y }: Pose): string =>
  m['world.at']({ thing: thingName(thing), x: Math.round(x), y: Math.round(y) })
