import 'fake-indexeddb/auto'
import { addBend, moveStation, setRoad, toggleGoal } from '@botgarten/maps/own'
import { mostOfMap, type RoadMap } from '@botgarten/programs'
import fc from 'fast-check'
import { afterEach, beforeEach, describe, expect, test } from 'vitest'
import { freshDevice } from '#storage/testing/device.ts'
import { Designer } from './designer.svelte.ts'
import { canLearn, join, pullFrom, tap, targetAt, type At, type Target } from './hands.ts'
import { drawn, openedWith, row } from './testing/opened.ts'

let designers: Designer[] = []
beforeEach(freshDevice)
afterEach(() => {
  for (const one of designers) one.close()
  designers = []
})

async function designing(map: RoadMap = row): Promise<Designer> {
  const designer = new Designer(await openedWith(map))
  designers.push(designer)
  return designer
}
const reach = 40
const paper = { kind: 'paper' } as const
const station = (index: number): Target => ({ kind: 'station', index })
const road = (index: number): Target => ({ kind: 'road', index })

/** Presses at a place, pulls through others and releases at the last one. */
function pulls(designer: Designer, from: At, ...through: readonly At[]): void {
  const pull = pullFrom(designer, targetAt(designer, from, reach), from)!
  for (const at of through) pull.move(at)
  const end = through.at(-1) ?? from
  pull.end(end, targetAt(designer, end, reach))
}

describe('a press is on', () => {
  test('a station within reach of its middle, else on a road near its line, else on the paper', async () => {
    const designer = await designing()
    const at = (x: number, y: number) => targetAt(designer, { x, y }, reach)
    expect([at(200, 540), at(240, 500), at(500, 500)]).toEqual([station(0), station(0), station(1)])
    // Roads are three quarters as wide: 30 units. They are sampled at points 8 units apart.
    expect([at(350, 525), at(650, 500), at(350, 541), at(900, 900)]).toEqual([road(0), road(1), paper, paper])
  })

  test('the station that was drawn last, where two lie on each other', async () => {
    const designer = await designing(moveStation(row, 2, { x: 510, y: 500 }))
    expect(targetAt(designer, { x: 505, y: 500 }, reach)).toEqual(station(2))
  })

  test('a bend of the chosen road alone, and not with the tool for signs', async () => {
    const bent = addBend(row, 0, 0, { x: 350, y: 600 })
    const designer = await designing(bent)
    const at = { x: 350, y: 600 }
    expect(targetAt(designer, at, reach).kind).not.toBe('bend')
    designer.chosen = { kind: 'road', index: 0 }
    expect(targetAt(designer, at, reach)).toEqual({ kind: 'bend', road: 0, bend: 0 })
    expect(targetAt(designer, { x: 350, y: 633 }, reach)).not.toMatchObject({ kind: 'bend' })
    designer.tool = 'sign'
    expect(targetAt(designer, at, reach).kind).not.toBe('bend')
  })
})

describe('a pull', () => {
  test('at a station moves it with its roads, as one step', async () => {
    const designer = await designing()
    pulls(designer, { x: 200, y: 500 }, { x: 300, y: 400 }, { x: 320, y: 380 })
    expect(designer.settled).toEqual(moveStation(row, 0, { x: 320, y: 380 }))
    expect(designer.chosen).toEqual(station(0))
    designer.undo()
    expect(designer.settled).toBe(row)
  })

  test('with the tool for roads joins two stations, and opens the new road', async () => {
    const designer = await designing()
    designer.tool = 'road'
    expect(pullFrom(designer, station(0), { x: 200, y: 500 })!.from).toBe(0)
    pulls(designer, { x: 800, y: 500 }, { x: 500, y: 700 }, { x: 210, y: 510 })
    expect(designer.settled.roads.at(-1)).toEqual({ from: 0, to: 2, bends: [] })
    expect(designer.chosen).toEqual({ kind: 'road', index: 2 })
  })

  test('that ends on the paper, or where it began, makes no road', async () => {
    const designer = await designing()
    designer.tool = 'road'
    pulls(designer, { x: 200, y: 500 }, { x: 900, y: 900 })
    pulls(designer, { x: 200, y: 500 }, { x: 205, y: 505 })
    expect([designer.settled, designer.canUndo]).toEqual([row, false])
  })

  test('at a road makes a bend where the user has it, between the right corners', async () => {
    const designer = await designing()
    pulls(designer, { x: 300, y: 500 }, { x: 300, y: 650 })
    expect(designer.settled.roads[0]!.bends).toEqual([{ x: 300, y: 650 }])
    // Between the bend and station 1 lies the second piece of the road.
    pulls(designer, { x: 450, y: 538 }, { x: 460, y: 700 })
    expect(designer.settled.roads[0]!.bends).toEqual([
      { x: 300, y: 650 },
      { x: 460, y: 700 },
    ])
    expect(designer.chosen).toEqual({ kind: 'road', index: 0 })
  })

  test('at a bend of the chosen road moves that bend', async () => {
    const designer = await designing(addBend(row, 1, 0, { x: 650, y: 600 }))
    designer.chosen = { kind: 'road', index: 1 }
    pulls(designer, { x: 650, y: 600 }, { x: 660, y: 700 })
    expect(designer.settled.roads[1]!.bends).toEqual([{ x: 660, y: 700 }])
    expect(designer.chosen).toEqual({ kind: 'road', index: 1 })
  })

  test('at a road with all its bends changes nothing', async () => {
    const full = Array.from({ length: mostOfMap.bends }, (_, k) => ({ x: 250 + 50 * k, y: 520 }))
    const designer = await designing(setRoad(row, 0, { bends: full }))
    const pull = pullFrom(designer, road(0), { x: 350, y: 520 })!
    pull.move({ x: 350, y: 800 })
    pull.end({ x: 350, y: 800 }, paper)
    expect(designer.canUndo).toBe(false)
  })

  test('does not begin on the paper', async () => {
    expect(pullFrom(await designing(), paper, { x: 10, y: 10 })).toBeNull()
  })

  test('anywhere along a road puts the bend into the piece that was pressed', async () => {
    const bends = [
      { x: 350, y: 300 },
      { x: 350, y: 700 },
    ]
    const designer = await designing(setRoad(row, 0, { bends }))
    const corners = [{ x: 200, y: 500 }, ...bends, { x: 500, y: 500 }]
    const share = fc.double({ min: 0.2, max: 0.8, noNaN: true })
    fc.assert(
      fc.property(fc.integer({ min: 0, max: 2 }), share, (piece, along) => {
        const [a, b] = [corners[piece]!, corners[piece + 1]!]
        const at = { x: a.x + along * (b.x - a.x), y: a.y + along * (b.y - a.y) }
        const pull = pullFrom(designer, road(0), at)!
        pull.move({ x: 1000, y: 900 })
        pull.end({ x: 1000, y: 900 }, paper)
        expect(designer.settled.roads[0]!.bends.findIndex(({ x }) => x === 1000)).toBe(piece)
        designer.undo()
      }),
    )
  })
})

describe('a tap', () => {
  test('on the paper makes a station and opens it; with other tools it closes what is open', async () => {
    const designer = await designing()
    tap(designer, paper, { x: 900, y: 200 })
    expect(designer.settled.stations[3]).toEqual({ x: 900, y: 200 })
    expect(designer.chosen).toEqual(station(3))
    designer.tool = 'road'
    tap(designer, paper, { x: 300, y: 200 })
    expect([designer.settled.stations.length, designer.chosen]).toEqual([4, null])
  })

  test('on the paper of a full map changes nothing', async () => {
    const places = Array.from({ length: mostOfMap.stations }, (_, k) => [100 + 30 * k, 500] as const)
    const designer = await designing(drawn(places))
    tap(designer, paper, { x: 900, y: 200 })
    expect([designer.canUndo, designer.chosen]).toEqual([false, null])
  })

  test('on a station or a road opens it, on a bend does nothing', async () => {
    const designer = await designing()
    tap(designer, station(1), { x: 500, y: 500 })
    expect(designer.chosen).toEqual(station(1))
    tap(designer, road(0), { x: 350, y: 500 })
    tap(designer, { kind: 'bend', road: 1, bend: 0 }, { x: 650, y: 500 })
    expect(designer.chosen).toEqual(road(0))
    expect(designer.canUndo).toBe(false)
  })

  test('with the tool for signs goes around: none, both ways closed, one way, the other', async () => {
    const designer = await designing()
    designer.tool = 'sign'
    const signs = ['both', 'there', 'back', undefined, 'both']
    for (const sign of signs) {
      tap(designer, road(0), { x: 350, y: 500 })
      expect(designer.settled.roads[0]!.closed).toBe(sign)
    }
    expect(designer.settled.roads[1]!.closed).toBeUndefined()
  })

  test('with the tool for signs on a one-way road closes and opens it', async () => {
    const designer = await designing(setRoad(row, 0, { oneWay: true }))
    designer.tool = 'sign'
    for (const sign of ['both', undefined]) {
      tap(designer, road(0), { x: 350, y: 500 })
      expect(designer.settled.roads[0]!.closed).toBe(sign)
    }
  })
})

test('joining two stations that have a road opens that road, whichever way it was drawn', async () => {
  const designer = await designing()
  join(designer, 2, 1)
  expect([designer.canUndo, designer.chosen]).toEqual([false, { kind: 'road', index: 1 }])
})

test('a map can be learned on with two stations, a goal that is not the start, and a way there', async () => {
  const learnable = async (map: RoadMap) => canLearn(map, (await designing(map)).reach)
  expect(await learnable(row)).toBe(true)
  expect(await learnable(drawn([[200, 500]]))).toBe(false)
  expect(await learnable({ ...row, goals: [0] })).toBe(false)
  expect(await learnable(setRoad(row, 0, { closed: 'both' }))).toBe(false)
  expect(await learnable(toggleGoal(row, 2))).toBe(true)
})
