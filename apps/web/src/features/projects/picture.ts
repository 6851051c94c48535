import { floorAddress } from '#content/cards.ts'
import type { Project } from '@botgarten/programs'
import type { Obstacle, World } from '@botgarten/simulation'

/** The picture of a tile is so many times as wide as it is high. */
const wide = 2.6
/** Cm around Bo that are seen: it is drawn larger than it is. */
const around = 40

/** Which stripe of a world is seen, in cm from its top: Bo and, where it fits, what is next to it. */
export function stripeOf({ size, robots, obstacles }: World): {
  readonly top: number
  readonly height: number
} {
  const height = Math.min(size.height, size.width / wide)
  const bo = robots[0]?.pose ?? { x: size.width / 2, y: size.height / 2 }
  const away = ({ pose }: Obstacle) => Math.hypot(pose.x - bo.x, pose.y - bo.y)
  const next = obstacles.toSorted((a, b) => away(a) - away(b))[0]?.pose ?? bo
  const most = Math.max(0, height / 2 - around)
  const middle = size.height - bo.y + Math.min(most, Math.max(-most, (bo.y - next.y) / 2))
  return { top: Math.min(size.height - height, Math.max(0, middle - height / 2)), height }
}

/** Address of the picture on the floor of a project's world, from the product or from the project itself. */
export function floorOf({ world, assets }: Pick<Project, 'world' | 'assets'>): string | null {
  const own = 'asset' in world.floor && Object.hasOwn(assets, world.floor.asset) && assets[world.floor.asset]
  return own ? `data:image/png;base64,${own.base64}` : floorAddress(world)
}
