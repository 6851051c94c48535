import { createLearner, run, shortestPath } from '@botgarten/learning/q-learning'
import { settingsOf } from '@botgarten/experiments/race'
import { stream } from '@botgarten/numbers'
import fc from 'fast-check'
import { beforeEach, describe, expect, test } from 'vitest'
import { laneOf } from './lanes.ts'
import { trackOn } from './testing/track.ts'
import { MORE, WalkModel } from './walk.svelte.ts'
import { movesOf } from './walked.ts'

const track = trackOn('railway')
const { world } = track
let walk: WalkModel
beforeEach(() => {
  walk = new WalkModel(track)
})

/** Takes doors until a try is over: `choose` gets the number of doors and returns an index. */
function tryOnce(choose: (doors: number) => number = () => 0): void {
  const over = walk.tries.length
  while (walk.tries.length === over) {
    const doors = walk.doorsOf(walk.here.state)
    walk.take(doors[choose(doors.length)]!.action)
  }
}
/** Along a way of fewest moves. */
function tryShortest(): void {
  const next = new Map<number, number>()
  const reached = new Set([world.start])
  for (const state of reached)
    for (const { action, to } of walk.doorsOf(state))
      if (!reached.has(to)) {
        reached.add(to)
        next.set(to, action)
      }
  const way: number[] = []
  for (let at = world.task.goal; at !== world.start; at = world.from[way[0]!]!) way.unshift(next.get(at)!)
  for (const action of way) walk.take(action)
  walk.next()
}

describe('a child that walks', () => {
  test('begins at the start with empty notes, and sees the doors of its room alone', () => {
    expect([walk.here, walk.rooms, walk.notes.some(Boolean)]).toEqual([
      { state: 3, from: null, fell: false },
      [3],
      false,
    ])
    expect(walk.now).toEqual({ states: [3], stars: 0, falls: 0, atGoal: false })
    for (const { action, to, side } of walk.doorsOf(3))
      expect([world.from[action], world.meant[action], side]).toEqual([3, to, null])
  })

  test('goes through a door, which is asked for stars then, and knows that room from now on', () => {
    const [door] = walk.doorsOf(3)
    walk.take(door!.action)
    expect(walk.here).toEqual({ state: door!.to, from: 3, fell: false })
    expect([walk.asked, walk.taken, walk.now.states]).toEqual([door!.action, [door!.action], [3, door!.to]])
    expect(walk.rooms).toEqual([3, door!.to].toSorted((a, b) => a - b))
    walk.note(door!.action, 4)
    expect(walk.notes[door!.action]).toBe(4)
    expect(walk.notes.filter(Boolean)).toEqual([4])
  })

  test('finds the goal by the shortest way, which ends the try', () => {
    tryShortest()
    const [first] = walk.tries
    expect([first!.atGoal, first!.states.length]).toEqual([true, shortestPath(world)])
    expect([walk.here.state, walk.now.states]).toEqual([world.start, [world.start]])
  })

  test('stops between two tries, where doors lead nowhere and the last door is still noted', () => {
    const [first] = walk.doorsOf(world.start)
    tryOnce()
    expect([walk.rests, walk.tries.length, walk.now]).toEqual([true, 1, walk.tries[0]])
    const door = walk.asked!
    walk.take(first!.action)
    expect([walk.now, walk.asked]).toEqual([walk.tries[0], door])
    walk.note(door, 5)
    walk.next()
    expect([walk.rests, walk.here.state, walk.now.states, walk.notes[door]]).toEqual([
      ...[false, world.start, [world.start], 5],
    ])
    const { now } = walk
    walk.next()
    expect(walk.now).toBe(now)
  })

  test('has three tries; then nothing moves any more until it begins again', () => {
    for (let tries = 0; tries < walk.count; tries += 1) tryShortest()
    expect([walk.count, walk.isOver]).toEqual([3, true])
    const { states } = walk.now
    walk.take(walk.doorsOf(world.start)[0]!.action)
    expect(walk.now.states).toBe(states)
    walk.note(0, 3)
    walk.begin()
    expect([walk.tries, walk.isOver, walk.learned, walk.taken, walk.asked]).toEqual([
      [],
      false,
      null,
      [],
      null,
    ])
    expect([walk.notes.some(Boolean), walk.here.state]).toEqual([false, world.start])
  })

  test('has its moves and stars added up, and ends at the latest after 20 moves for each station', () => {
    const choices = fc.infiniteStream(fc.nat(11))
    fc.assert(
      fc.property(choices, (choice) => {
        walk.begin()
        tryOnce((doors) => choice.next().value! % doors)
        const [tried] = walk.tries
        expect(movesOf(tried!)).toBeLessThanOrEqual(20 * world.states)
        expect(tried!.states[0]).toBe(world.start)
        for (const [k, to] of tried!.states.slice(1).entries()) {
          const from = tried!.states[k]!
          expect(walk.doorsOf(from).map((door) => door.to)).toContain(to)
        }
        expect(tried!.atGoal).toBe(tried!.states.at(-1) === world.task.goal)
      }),
    )
  })
})

describe('rooms of a grid', () => {
  const grid = new WalkModel(trackOn('cliff'))

  test('have doors by their sides', () => {
    const sides = grid.doorsOf(grid.track.world.start).map(({ side }) => side)
    expect(sides.length).toBeGreaterThan(0)
    for (const side of sides) expect(['left', 'right', 'up', 'down']).toContain(side)
  })

  test('have a cliff: who falls begins at the start and has a fall more', () => {
    grid.begin()
    const { world } = grid.track
    const falls = world.names.findIndex((_, action) => world.isFall[world.outcome[action]!] === 1)
    expect(falls).toBeGreaterThanOrEqual(0)
    grid.here = { state: world.from[falls]!, from: null, fell: false }
    grid.take(falls)
    const fallen = grid.tries.at(-1) ?? grid.now
    expect(fallen.falls).toBe(1)
    expect(fallen.stars).toBeLessThan(0)
  })
})

describe('Bo next to the child', () => {
  const bo = (tries: number) => {
    const learner = createLearner(world, settingsOf(laneOf('q')), stream(1, 'race/bo/1'))
    run(learner, Infinity, tries)
    return learner
  }

  test('has learned from three tries what the learner itself learns from them, and from 20 more', () => {
    for (let tries = 0; tries < 3; tries += 1) {
      expect(walk.learned).toBeNull()
      tryShortest()
    }
    expect([walk.learned!.tries.length, walk.learned!.q]).toEqual([3, [...bo(3).q]])
    walk.letBoGoOn()
    expect([walk.learned!.tries.length, walk.learned!.q]).toEqual([3 + MORE, [...bo(3 + MORE).q]])
    const moves = walk.learned!.tries.reduce((sum, tried) => sum + movesOf(tried), 0)
    expect(moves).toBe(bo(3 + MORE).steps)
  })

  test('throws the same dice when the child begins again', () => {
    for (let tries = 0; tries < 3; tries += 1) tryShortest()
    const { q } = walk.learned!
    walk.begin()
    for (let tries = 0; tries < 3; tries += 1) tryShortest()
    expect(walk.learned!.q).toEqual(q)
  })
})

test('a walk has begun once a door was taken', () => {
  expect(walk.hasBegun).toBe(false)
  walk.take(walk.doorsOf(walk.here.state)[0]!.action)
  expect(walk.hasBegun).toBe(true)
})
