import type { View } from '@botgarten/lab'
import type { Obstacle, Pose, World } from '@botgarten/simulation'

/** An obstacle of the world where it stands now. */
export interface Standing {
  readonly id: string
  readonly pose: Pose
  readonly thing: Obstacle
}

const same = (a: Pose, b: Pose) => a.x === b.x && a.y === b.y && a.heading === b.heading

/** The view's obstacles with their looks. What has not moved is the same object as in `before`: nothing is drawn again for it. */
export function standing(view: View, world: World, before: readonly Standing[]): readonly Standing[] {
  const kept = new Map(before.map((one) => [one.id, one]))
  const things = new Map(world.obstacles.map((thing) => [thing.id, thing]))
  const next = view.obstacles.flatMap(({ id, pose }): readonly Standing[] => {
    const thing = things.get(id)
    const old = kept.get(id)
    if (!thing) return []
    return [old && old.thing === thing && same(old.pose, pose) ? old : { id, pose, thing }]
  })
  const unchanged = next.length === before.length && next.every((one, i) => one === before[i])
  return unchanged ? before : next
}
