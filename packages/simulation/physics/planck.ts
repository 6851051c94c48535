// The order of the first three imports is what this file is for: see lend-math.ts.
import './lend-math.ts'
import { Box, Circle, Polygon, Rot, Settings, Vec2, World } from 'planck'
import './return-math.ts'
import { cos, sin } from '@botgarten/numbers'
import type { Body, Contact, Fixture } from 'planck'

// Lengths are cm.
Settings.maxTranslation = 50

/** Does this part of the library compute with our functions? */
export function usesOurMath(rot: Pick<Rot, 's' | 'c' | 'setAngle'>): boolean {
  for (let angle = 0.5; angle < 300; angle += 0.97) {
    rot.setAngle(angle)
    if (rot.s !== sin(angle) || rot.c !== cos(angle)) return false
  }
  return true
}

// A bundler that moved the library in front of lend-math.ts is found out here.
if (!usesOurMath(Rot.identity()))
  throw new Error('The physics library was loaded without the functions of packages/numbers.')

/** What is used here of the library's insides. They are not in its types; its version is pinned. */
export interface InnerWorld {
  m_contactList: InnerContact | null
  createContact(a: unknown, b: unknown): void
  destroyContact(contact: InnerContact): void
  findNewContacts(): void
  updateContacts(): void
}

type InnerContact = Contact & { m_next: InnerContact | null; update(world: World): void }

export type InnerFixture = Fixture & { m_proxies: readonly unknown[] }

export interface InnerBody {
  m_sweep: {
    readonly c: { x: number; y: number }
    readonly c0: { x: number; y: number }
    a: number
    a0: number
    alpha0: number
  }
}

export { Box, Circle, Polygon, Rot, Vec2, World, type Body }
