import type { Pose } from '@botgarten/simulation'

/** By the ids of robots and things. */
export type Poses = { readonly [id: string]: Pose }

interface Placed {
  readonly id: string
  readonly pose: Pose
}

/** Where everything of a world, or of a view of one, stands. */
export const posesOf = ({
  robots,
  obstacles,
}: {
  robots: readonly Placed[]
  obstacles: readonly Placed[]
}): Poses => Object.fromEntries([...robots, ...obstacles].map(({ id, pose }) => [id, pose]))
