import type { Pose, World } from '@botgarten/simulation'

/** A world as a child builds it: all but the robots, and where they start, in their order. */
export interface Scene extends Pick<World, 'size' | 'floor' | 'areas' | 'lines' | 'obstacles'> {
  readonly starts: readonly Pose[]
}

export const sceneOf = ({ size, floor, areas, lines, obstacles, robots }: World): Scene => ({
  ...{ size, floor, areas, lines, obstacles },
  starts: robots.map(({ pose }) => pose),
})

/** The world with another scene around its robots. Robots without a start in it keep theirs. */
export const inScene = (world: World, { starts, ...scene }: Scene): World => ({
  ...{ size: scene.size, floor: scene.floor },
  ...{ areas: scene.areas, lines: scene.lines, obstacles: scene.obstacles },
  robots: world.robots.map((robot, index) => ({ ...robot, pose: starts[index] ?? robot.pose })),
})
