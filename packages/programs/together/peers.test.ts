import fc from 'fast-check'
import * as v from 'valibot'
import { expect, test } from 'vitest'
import { projectSchema } from '../project/schema.ts'
import { project } from '../testing/every-part.ts'
import { randomPrograms } from '../testing/random-programs.ts'
import { Peer } from './peer.ts'
import { anyOperation, idsOf, sharedWith } from './testing/hands.ts'
import type { Back } from './undo.ts'
import type { Entry, Shared } from './types.ts'

/** The common order, and what has been deleted by a hand. */
class Room {
  readonly log: Entry[] = []
  readonly deleted = new Set<string>()
  readonly known: Set<string>
  readonly peers: readonly Peer[]
  readonly #backs: [Back[][], Back[][]] = [[], []]
  #count = 0

  constructor(start: Shared) {
    this.known = new Set(idsOf(start))
    this.peers = [new Peer('a', start), new Peer('b', start)]
  }

  /** A hand does something: what is not there any more afterwards was deleted by it. */
  #do(who: number, act: () => readonly Back[]): void {
    const peer = this.peers[who]!
    const before = idsOf(peer.shared)
    const backs = act()
    if (backs.length > 0) this.#backs[who]!.push([...backs])
    const after = idsOf(peer.shared)
    for (const id of before) if (!after.has(id)) this.deleted.add(id)
    for (const id of after) this.known.add(id)
  }

  edit(who: number, dice: (sides: number) => number): void {
    const peer = this.peers[who]!
    this.#do(who, () => peer.edit([anyOperation(peer.shared, dice, `new-${this.#count++}`)]))
  }
  undo(who: number): void {
    const backs = this.#backs[who]!.pop()
    if (backs) this.#do(who, () => (this.peers[who]!.undo(backs), []))
  }
  /** Sends so many; the answer may never come, and then they are sent once more. */
  send(who: number, count: number): void {
    const { pending, author } = this.peers[who]!
    const last = this.log.reduce((most, { by, n }) => (by === author ? Math.max(most, n) : most), 0)
    this.log.push(...pending.slice(0, count).filter(({ n }) => n > last))
  }
  /** Hears so much of the common order, some of it once more. */
  hear(who: number, count: number, again: number): void {
    const peer = this.peers[who]!
    const from = Math.max(0, peer.length - again)
    peer.receive(from, this.log.slice(from, peer.length + count))
  }
  settle(): void {
    for (const who of [0, 1]) this.send(who, Infinity)
    for (const who of [0, 1]) this.hear(who, Infinity, 0)
  }
}

const step = fc.tuple(fc.nat(1), fc.nat(9), fc.array(fc.nat(9999), { minLength: 5, maxLength: 5 }))

function play(room: Room, [who, what, numbers]: readonly [number, number, readonly number[]]): void {
  let at = 0
  const dice = (sides: number) => numbers[at++ % numbers.length]! % sides
  if (what < 6) room.edit(who, dice)
  else if (what === 6) room.undo(who)
  else if (what === 7) room.send(who, dice(4))
  else room.hear(who, dice(4), dice(3))
}

test('2,000 pairs of edit lists, any delay, cut and order: both ends equal, valid, no block gone that nobody deleted', () => {
  fc.assert(
    fc.property(randomPrograms, fc.array(step, { minLength: 4, maxLength: 24 }), (main, steps) => {
      const room = new Room(sharedWith(main))
      for (const one of steps) play(room, one)
      room.settle()
      const [a, b] = room.peers.map(({ shared }) => shared)
      expect(JSON.stringify(a)).toBe(JSON.stringify(b))
      const { issues } = v.safeParse(projectSchema, { ...project, ...a })
      expect(issues).toBeUndefined()
      const left = idsOf(a!)
      for (const id of room.known) if (!left.has(id)) expect(room.deleted).toContain(id)
      expect(room.peers.every(({ pending }) => pending.length === 0)).toBe(true)
    }),
    { numRuns: 2000 },
  )
})
