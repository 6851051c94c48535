import type { NearParts } from '../geometry/near.ts'
import { TICKS_PER_SECOND } from '../time.ts'
import type { Cm, Radians } from '../types.ts'
import type { Physics, PhysicsBody } from './bodies.ts'

const VELOCITY_ROUNDS = 8
const POSITION_ROUNDS = 6

/** Place of a body, and its speed in cm/s and rad/s. */
export interface Moving {
  x: Cm
  y: Cm
  heading: Radians
  vx: number
  vy: number
  spin: number
}

/**
 * One tick of physics: active bodies start where `moving` says and as fast as it says; afterwards it says where they
 * came to and how fast they are. Nothing else that physics remembers has any influence (running.md 8).
 */
export function stepPhysics(physics: Physics, near: NearParts, moving: readonly Moving[]): void {
  const { bodies, world } = physics
  while (world.m_contactList) world.destroyContact(world.m_contactList)
  for (let body = 0; body < bodies.length; body++) {
    const own = bodies[body]!
    if (near.active[body] === 1) {
      put(own, moving[body]!)
      send(own, moving[body]!)
    } else {
      if (!isAt(own, moving[body]!)) put(own, moving[body]!)
      own.setAwake(false)
    }
  }
  makeContacts(physics, near)
  world.step(1 / TICKS_PER_SECOND, VELOCITY_ROUNDS, POSITION_ROUNDS)
  for (let body = 0; body < bodies.length; body++) {
    if (near.active[body] === 1) take(bodies[body]!, moving[body]!)
  }
}

/** Even a fixed body is carried off by a last bit when the library looks for the moment of an impact. */
function isAt({ m_sweep: { c, c0, a, a0 } }: PhysicsBody, { x, y, heading }: Moving): boolean {
  return c.x === x && c0.x === x && c.y === y && c0.y === y && a === heading && a0 === heading
}

/** Not `setTransform`: it takes the angle through atan2 and loses whole turns and the last bit. */
function put(body: PhysicsBody, from: Moving): void {
  const sweep = body.m_sweep
  sweep.c.x = sweep.c0.x = from.x
  sweep.c.y = sweep.c0.y = from.y
  sweep.a = sweep.a0 = from.heading
  sweep.alpha0 = 0
  body.synchronizeTransform()
}

function send(body: PhysicsBody, from: Moving): void {
  body.setAwake(true)
  const velocity = body.getLinearVelocity()
  velocity.x = from.vx
  velocity.y = from.vy
  body.setAngularVelocity(from.spin)
}

function take(body: PhysicsBody, to: Moving): void {
  const { c, a } = body.m_sweep
  const velocity = body.getLinearVelocity()
  to.x = c.x
  to.y = c.y
  to.heading = a
  to.vx = velocity.x
  to.vy = velocity.y
  to.spin = body.getAngularVelocity()
}

function makeContacts({ world, parts, sides }: Physics, near: NearParts): void {
  for (let pair = 0; pair < near.count; pair++) {
    const b = near.b[pair]!
    const other = b < 0 ? sides[-1 - b]! : parts[b]!
    world.createContact(parts[near.a[pair]!]!.m_proxies[0], other.m_proxies[0])
  }
}
