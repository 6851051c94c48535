import type { Obstacle } from '@botgarten/simulation'
import { m } from '#words/message.ts'

const names: { readonly [look: string]: () => string } = {
  block: m['world.thing.block'],
  crate: m['world.thing.crate'],
  rock: m['world.thing.rock'],
  tree: m['world.thing.tree'],
  wall: m['world.thing.wall'],
  ball: m['world.thing.ball'],
  rectangle: m['world.thing.rectangle'],
  triangle: m['world.thing.triangle'],
  circle: m['world.thing.circle'],
}

/** What a child calls an obstacle that looks like this; one without a look by its shape. */
export const thingName = ({ look, shape }: Pick<Obstacle, 'look' | 'shape'>): string =>
  (names[look ?? ''] ?? names[shape.kind] ?? m['world.thing.plain'])()
