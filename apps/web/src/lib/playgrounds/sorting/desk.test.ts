import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest'
import { Desk } from './desk.svelte.ts'
import { traps } from './traps.ts'

const shelf = new Map<string, string>()
beforeEach(() => {
  vi.useFakeTimers()
  shelf.clear()
  vi.stubGlobal('localStorage', {
    getItem: (key: string) => shelf.get(key) ?? null,
    setItem: (key: string, value: string) => shelf.set(key, value),
  })
})
afterEach(() => {
  vi.useRealTimers()
  vi.unstubAllGlobals()
})

describe('the sorting desk', () => {
  test('opens with things on the table and as many flags as are said', () => {
    const desk = new Desk()
    expect(desk.work).toMatchObject({ source: 'things', set: 'vessels', flags: 3 })
    expect(desk.work.state?.centres).toHaveLength(3)
  })

  test('plays to the end, and the line leads back to every step', () => {
    const desk = new Desk()
    desk.play()
    vi.advanceTimersByTime(60_000)
    expect(desk.done).toBe(true)
    expect(desk.playing).toBe(false)
    expect(desk.work.state!.labels.every((label) => label >= 0)).toBe(true)
    const { state } = desk.work
    desk.goTo(0)
    expect(desk.work.state!.labels.every((label) => label === -1)).toBe(true)
    for (let step = 0; step < 100 && !desk.done; step++) desk.stepAll()
    expect(desk.work.state).toEqual(state)
  })

  test('point by point and flag by flag comes to the same end', () => {
    const [one, all] = [new Desk(), new Desk()]
    for (let step = 0; step < 300 && !one.done; step++) one.stepOne()
    for (let step = 0; step < 100 && !all.done; step++) all.stepAll()
    expect(one.work.state).toEqual(all.work.state)
  })

  test('again is the same flags at their first places', () => {
    const desk = new Desk()
    const { centres } = desk.work.state!
    for (let step = 0; step < 100 && !desk.done; step++) desk.stepAll()
    expect(desk.work.state!.centres).not.toEqual(centres)
    desk.again()
    expect(desk.work.state!.centres).toEqual(centres)
    expect(desk.work.state!.round).toBe(0)
  })

  test('the criterion decides: other features, other groups; none at all sorts nothing', () => {
    const desk = new Desk()
    const groups = () => {
      desk.throwFlags('best')
      for (let step = 0; step < 100 && !desk.done; step++) desk.stepAll()
      return desk.work.state!.labels
    }
    const byShape = groups()
    desk.count('width', false)
    desk.count('height', false)
    expect(desk.work.state).toBeNull()
    desk.count('colour', true)
    expect(desk.work.table.columns).toHaveLength(3)
    const pairs = (labels: readonly number[]) => labels.map((a) => labels.map((b) => a === b))
    expect(pairs(groups())).not.toEqual(pairs(byShape))
  })

  test('never has more flags than points, and none without points', () => {
    const desk = new Desk()
    desk.turnTo('points')
    desk.clearPoints()
    expect(desk.work.state).toBeNull()
    desk.stepAll()
    desk.addPoint(1, 1)
    desk.addPoint(9, 9)
    expect(desk.work.state!.centres.length).toBeLessThanOrEqual(2)
    desk.setFlags(6)
    expect(desk.work.flags).toBe(2)
    desk.removePoint(0)
    expect(desk.work.flags).toBe(1)
    desk.setFlags(0)
    expect(desk.work.flags).toBe(1)
  })

  test('a drag of a flag is one step on the line', () => {
    const desk = new Desk()
    const before = desk.last
    for (const x of [1, 2, 3]) desk.placeFlag(0, [x, 4], true)
    desk.placeFlag(0, [5, 4], false)
    expect(desk.work.state!.centres[0]).toEqual([5, 4])
    expect(desk.last).toBe(before + 1)
  })

  test('is found again as it was left, with its names', () => {
    const desk = new Desk()
    desk.takeTrap('moons')
    desk.setFlags(4)
    desk.name(2, 'Half moon')
    const again = new Desk()
    expect(again.work.table).toEqual(desk.work.table)
    expect(again.work.state!.centres).toEqual(desk.work.state!.centres)
    expect(again.nameOf(2)).toBe('Half moon')
  })

  test.each(['{"source":"things","set":"cars"}', '[1,2]', '{"rows":[[null]]}', 'not json'])(
    'what is broken on the device is the first desk: %s',
    (text) => {
      shelf.set('botgarten.sorting', text)
      expect(new Desk().work).toMatchObject({ source: 'things', set: 'vessels' })
    },
  )

  test.each(Object.keys(traps))('the trap %s lies on the plane and can be sorted', (name) => {
    const desk = new Desk()
    desk.takeTrap(name)
    for (const value of desk.work.table.rows.flat()) expect(value >= 0 && value <= 10).toBe(true)
    for (let step = 0; step < 200 && !desk.done; step++) desk.stepAll()
    expect(desk.done).toBe(true)
  })

  test('moons are cut: k-means puts points of both arcs together', () => {
    const desk = new Desk()
    desk.takeTrap('moons')
    desk.throwFlags('best')
    for (let step = 0; step < 200 && !desk.done; step++) desk.stepAll()
    const { labels } = desk.work.state!
    const first = new Set(labels.slice(0, 32))
    const second = new Set(labels.slice(32))
    expect(first.size + second.size).toBeGreaterThan(2)
  })
})
