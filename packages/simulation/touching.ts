import { EDGE } from './physics/bodies.ts'
import type { Scene } from './scene.ts'
import type { World } from './types.ts'

/** Writes down what each robot that took part in this tick's physics touches: ids in the world's order, then 'edge'. */
export function noteTouching(scene: Scene): void {
  const { physics, ground, near, state, touched } = scene
  const { bodyOf, bodies } = ground.outlines
  touched.fill(0)
  for (let contact = physics!.world.m_contactList; contact; contact = contact.m_next) {
    if (!contact.isTouching()) continue
    const a = contact.getFixtureA().getUserData() as number
    const b = contact.getFixtureB().getUserData() as number
    mark(scene, a === EDGE ? bodies : bodyOf[a]!, b === EDGE ? bodies : bodyOf[b]!)
  }
  for (let robot = 0; robot < state.robots.length; robot++) {
    if (near.active[robot] === 1) write(scene, robot)
  }
}

/** Rows are robots, columns all bodies and the edge. */
function mark({ state, touched, ground }: Scene, a: number, b: number): void {
  const columns = ground.outlines.bodies + 1
  if (a < state.robots.length) touched[a * columns + b] = 1
  if (b < state.robots.length) touched[b * columns + a] = 1
}

function write({ world, state, touched, ground }: Scene, robot: number): void {
  const columns = ground.outlines.bodies + 1
  const own = state.robots[robot]!
  const ids: string[] = []
  for (let body = 0; body < columns; body++)
    if (touched[robot * columns + body] === 1) ids.push(nameOf(world, body))
  const isSame = ids.length === own.touching.length && ids.every((id, index) => id === own.touching[index])
  if (!isSame) own.touching = ids
}

function nameOf({ robots, obstacles }: World, body: number): string {
  return (robots[body] ?? obstacles[body - robots.length])?.id ?? 'edge'
}
