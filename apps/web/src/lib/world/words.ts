import type { Obstacle } from '@botgarten/simulation'
import { m } from '#lib/words/generated/messages.js'

const names: { readonly [look: string]: () => string } = {
  block: m['world.thing.block'],
  crate: m['world.thing.crate'],
  rock: m['world.thing.rock'],
  tree: m['world.thing.tree'],
  wall: m['world.thing.wall'],
  ball: m['world.thing.ball'],
}

/** What a child calls an obstacle that looks like this. */
export const thingName = ({ look }: Obstacle): string => (names[look ?? ''] ?? m['world.thing.plain'])()
