import type { Part } from '../geometry/parts.ts'
import type { Cm } from '../types.ts'
import { Box, Circle, Polygon, Vec2, World } from './planck.ts'
import type { Body, InnerBody, InnerFixture, InnerWorld } from './planck.ts'

/** A body as physics needs it. Mass in crates (30 × 30 cm weigh 1), inertia in crates · cm²; null: it stands fast. */
export interface BodyPlan {
  readonly parts: readonly Part[]
  readonly x: Cm
  readonly y: Cm
  readonly heading: number
  readonly weight: { readonly mass: number; readonly inertia: number } | null
}

export type PhysicsBody = Body & InnerBody

export interface Physics {
  readonly world: World & InnerWorld
  readonly bodies: readonly PhysicsBody[]
  /** By part, and by side of the floor: left, right, bottom, top. */
  readonly parts: readonly InnerFixture[]
  readonly sides: readonly InnerFixture[]
}

/** Stands for the floor's edge where a part is asked for. */
export const EDGE = -1

const SIDE_DEPTH: Cm = 50
const FRICTION = 0.2

/** Builds the physics world. Bodies turn and weigh round their own origin, so that their place is kept to the last bit. */
export function buildPhysics(plans: readonly BodyPlan[], width: Cm, height: Cm): Physics {
  const world = new World({ gravity: { x: 0, y: 0 }, allowSleep: false, warmStarting: false }) as World &
    InnerWorld
  choosesNoContacts(world)
  const bodies: PhysicsBody[] = []
  const parts: InnerFixture[] = []
  for (const plan of plans) bodies.push(addBody(world, plan, parts))
  return { world, bodies, parts, sides: addSides(world, width, height) }
}

/**
 * Contacts are made by hand before every step (step.ts), so that none depends on what was before (running.md 8). What
 * the library does to find and drop them by itself is left out.
 */
function choosesNoContacts(world: World & InnerWorld): void {
  world.findNewContacts = () => undefined
  world.updateContacts = () => {
    for (let contact = world.m_contactList; contact; contact = contact.m_next) contact.update(world)
  }
}

function addBody(world: World, plan: BodyPlan, parts: InnerFixture[]): PhysicsBody {
  const body = world.createBody({
    type: plan.weight ? 'dynamic' : 'static',
    position: { x: plan.x, y: plan.y },
    angle: plan.heading,
    bullet: true,
  })
  for (const part of plan.parts) {
    const fixture = body.createFixture({
      shape: shapeOf(part),
      density: 1,
      friction: FRICTION,
      userData: parts.length,
    })
    parts.push(fixture as unknown as InnerFixture)
  }
  if (plan.weight) body.setMassData({ mass: plan.weight.mass, I: plan.weight.inertia, center: Vec2(0, 0) })
  // Boxes round the fixtures serve only the search for contacts.
  body.synchronizeFixtures = () => undefined
  return body as unknown as PhysicsBody
}

function shapeOf(part: Part) {
  if (part.kind === 'circle') return new Circle(part.radius)
  return new Polygon(part.corners.map(([x, y]) => Vec2(x, y)))
}

function addSides(world: World, width: Cm, height: Cm): InnerFixture[] {
  const body = world.createBody()
  const wall = (x: Cm, y: Cm, halfWidth: Cm, halfHeight: Cm) =>
    body.createFixture({
      shape: new Box(halfWidth, halfHeight, Vec2(x, y)),
      friction: FRICTION,
      userData: EDGE,
    }) as unknown as InnerFixture
  const half = SIDE_DEPTH / 2
  const acrossX = width / 2 + SIDE_DEPTH
  const acrossY = height / 2 + SIDE_DEPTH
  return [
    wall(0 - half, height / 2, half, acrossY),
    wall(width + half, height / 2, half, acrossY),
    wall(width / 2, 0 - half, acrossX, half),
    wall(width / 2, height + half, acrossX, half),
  ]
}
