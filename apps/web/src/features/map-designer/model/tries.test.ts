import { drivesRoad, roadsToTry } from '@botgarten/experiments/roads'
import { readMap } from '@botgarten/maps'
import { addRoad, setDress, setRoad, writeMap } from '@botgarten/maps/own'
import type { RoadMap } from '@botgarten/programs'
import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { workersHere } from '#lab/testing/worker.ts'
import { drawn } from './testing/opened.ts'
import { RoadTries } from './tries.svelte.ts'

let tries: RoadTries
let workers: ReturnType<typeof workersHere>
beforeEach(() => {
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] })
  workers = workersHere(() => import('./tries-worker.ts'))
  tries = new RoadTries()
})
afterEach(() => {
  tries.close()
  vi.useRealTimers()
  vi.unstubAllGlobals()
})

/** A straight road of 2.5 m; the same with a bend that is far too tight, and another road. */
const straight = drawn([[200, 200], [700, 200], [700, 700]], [[0, 1]]) // prettier-ignore
const bends = [{ x: 400, y: 200 }, { x: 400, y: 260 }, { x: 440, y: 200 }] // prettier-ignore
const bent = setRoad(addRoad(straight, 1, 2), 0, { bends })

const calm = () => vi.advanceTimersByTime(600)
/** Workers first load their code. */
const allTried = (count: number) =>
  vi.waitFor(() => expect(tries.tried).toBe(count), { timeout: 30_000, interval: 5 })
/** How many roads of a map Bo drives to their end in both directions, tried one after the other. */
function drivable(map: RoadMap): number {
  const file = readMap(writeMap(setDress(map, 'paper'), 'tried')).map!
  const driven = roadsToTry(file).filter((road) => drivesRoad(file, road))
  const isDriven = (from: number, to: number) => driven.some(([a, b]) => a === from && b === to)
  return map.roads.filter(({ from, to }) => isDriven(from, to) && isDriven(to, from)).length
}

test('Bo tries every road in both directions, once the user is calm, and finds those that cannot be driven', async () => {
  tries.follow(bent)
  vi.advanceTimersByTime(599)
  expect([tries.all, tries.tried, workers.length]).toEqual([2, 0, 0])
  vi.advanceTimersByTime(1)
  await allTried(2)
  expect(tries.driven).toBe(drivable(bent))
  expect(tries.driven).toBeLessThan(2)
})

test('what was tried is not tried again: another map has its new roads left', async () => {
  tries.follow(straight)
  calm()
  await allTried(1)
  expect(tries.driven).toBe(1)
  tries.follow(addRoad(straight, 1, 2))
  expect([tries.all, tries.tried]).toEqual([2, 1])
  calm()
  await allTried(2)
  tries.follow(straight)
  expect([tries.all, tries.tried]).toEqual([1, 1])
  expect(workers).toHaveLength(2)
})

test('a photo or another look changes no road', async () => {
  tries.follow(straight)
  calm()
  await allTried(1)
  tries.follow({ ...straight, dress: 'photo', photo: '/9j/AAAA' })
  expect([tries.all, tries.tried]).toEqual([1, 1])
})

test('a map that was closed is tried no further', () => {
  tries.follow(straight)
  calm()
  tries.close()
  expect(workers.map(({ isOver }) => isOver)).toEqual([true, true])
  tries.follow(bent)
  tries.close()
  calm()
  expect(tries.tried).toBe(0)
})

test('a closed road is no road that Bo could drive; one that is closed in one direction is', () => {
  const closed = (ways: 'both' | 'there') => setRoad(addRoad(straight, 1, 2), 1, { closed: ways })
  tries.follow(closed('both'))
  expect(tries.all).toBe(1)
  tries.follow(closed('there'))
  expect(tries.all).toBe(2)
})
