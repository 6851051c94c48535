import * as v from 'valibot'
import { clamp } from '#drawing/points.ts'
import type { World } from '@botgarten/simulation'

// Something in the gallery of a class, as the server answers it to a pupil and to the teacher.

const world = v.custom<World>((value) => typeof value === 'object' && value !== null)

/** What something was made from. Null: it is gone, or out of sight. */
const ancestor = v.object({
  id: v.string(),
  title: v.nullable(v.string()),
  by: v.nullable(v.string()),
  own: v.boolean(),
})
export type Ancestor = v.InferOutput<typeof ancestor>

export const item = v.object({
  id: v.string(),
  title: v.string(),
  card: v.nullable(v.string()),
  /** When it was shared, ms since 1970. */
  at: v.number(),
  by: v.string(),
  own: v.boolean(),
  /** Is there a network? */
  brain: v.boolean(),
  /** It shows a photo of its own. */
  photo: v.boolean(),
  hidden: v.boolean(),
  /** For the teacher's yes to its photo. */
  waiting: v.boolean(),
  hearts: v.number(),
  /** Has it a heart of the child that asks? */
  mine: v.boolean(),
  world,
  from: v.nullable(ancestor),
})
export type Item = v.InferOutput<typeof item>

export const looked = v.object({ ...item.entries, chain: v.array(ancestor), project: v.unknown() })
export type Looked = v.InferOutput<typeof looked>

/** The picture of a tile is so many times as wide as it is high. */
const wide = 1.5
/** In cm: more of a world is not seen on a tile. */
const highest = 240

/** The part of a world that a tile shows: Bo in its middle where the floor reaches so far. */
export function tilePart({ size, robots }: Pick<World, 'size' | 'robots'>) {
  const height = Math.min(size.height, size.width / wide, highest)
  // What is divided and multiplied again may be a little more than it was.
  const width = Math.min(size.width, height * wide)
  const bo = robots[0]?.pose ?? { x: size.width / 2, y: size.height / 2 }
  const left = clamp(bo.x - width / 2, 0, size.width - width)
  const top = clamp(size.height - bo.y - height / 2, 0, size.height - height)
  return { left, top, width, height }
}

/** A world that can be drawn as a project's, without the photo on its floor. */
export const pictured = ({ world }: Pick<Item, 'world'>) => ({ world, assets: {} })
