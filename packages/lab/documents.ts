import type { Pose } from '@botgarten/simulation'
import { brainsFor } from './robots/brains.ts'
import type { Document } from './types.ts'

/** Is it the same program, at most laid out differently on the canvas? */
export const sameBlocks = (a: Document['programs'], b: Document['programs']): boolean =>
  a === b || meaningOf(a) === meaningOf(b)

const meaningOf = (programs: Document['programs']) =>
  JSON.stringify(Object.entries(programs).map(([id, { stacks }]) => [id, stacks.map(({ blocks }) => blocks)]))

/** The document with a brain for every network block of its programs. */
export const withBrains = (document: Document): Document => ({
  ...document,
  brains: brainsFor(document.programs, document.brains),
})

/** The world with other start poses for some things; robots have theirs changed only where that is wanted. */
export function withPoses(
  world: Document['world'],
  poses: { readonly [id: string]: Pose },
  robotsToo: boolean,
): Document['world'] {
  const put = <Thing extends { id: string; pose: Pose }>(things: readonly Thing[]) =>
    things.map((thing) => {
      const pose = Object.hasOwn(poses, thing.id) ? poses[thing.id] : undefined
      return pose ? { ...thing, pose } : thing
    })
  return { ...world, obstacles: put(world.obstacles), robots: robotsToo ? put(world.robots) : world.robots }
}

export const emptyWorld: Document['world'] = {
  size: { width: 100, height: 100 },
  floor: { colour: '#FFFFFF' },
  areas: [],
  lines: [],
  obstacles: [],
  robots: [],
}
