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

  const red = [255, 0, 0]
  const blue = [0, 0, 255]
  const drives = (desk: Desk, readings: number) => {
    for (let reading = 0; reading < readings; reading++) desk.collect([reading % 2 === 0 ? red : blue])
  }

  test('a page without anything on it shows nothing of the page before', () => {
    const desk = new Desk()
    desk.play()
    vi.advanceTimersByTime(60_000)
    expect(desk.done).toBe(true)
    desk.turnTo('readings')
    expect(desk.work).toMatchObject({ source: 'readings', state: null, flags: 3, table: { rows: [] } })
    expect(desk.done).toBe(false)
    desk.turnTo('points')
    desk.takeTrap('moons')
    desk.stepAll()
    desk.turnTo('readings')
    expect([desk.work.state, desk.work.axes]).toEqual([null, [0, 2]])
  })

  test('what Bo reads lies on the plane while it drives; flags come when it ends, and all of it is one step', () => {
    const desk = new Desk()
    desk.turnTo('readings')
    const before = desk.last
    drives(desk, 5)
    expect(desk.work.table.rows).toHaveLength(5)
    expect(desk.work.table.rows[0]).toEqual([10, 0, 0])
    expect(desk.work.state).toBeNull()
    desk.endCollecting()
    expect(desk.work.state!.centres).toHaveLength(3)
    expect(desk.last).toBe(before + 1)
    desk.goTo(before)
    expect(desk.work.table.rows).toEqual([])
  })

  test('a short drive that leaves no room for three flags does not keep them away for ever', () => {
    const desk = new Desk()
    desk.turnTo('readings')
    drives(desk, 1)
    desk.endCollecting()
    expect(desk.work.flags).toBe(1)
    drives(desk, 4)
    desk.endCollecting()
    expect(desk.work.flags).toBe(3)
    desk.setFlags(2)
    drives(desk, 4)
    desk.endCollecting()
    expect(desk.work.flags).toBe(2)
  })

  test('other flags while Bo drives are those of the drive; a step back ends it', () => {
    const desk = new Desk()
    desk.turnTo('readings')
    const before = desk.last
    drives(desk, 8)
    desk.setFlags(4)
    drives(desk, 2)
    expect(desk.collecting).toBe(true)
    desk.goTo(before)
    expect(desk.collecting).toBe(false)
    desk.goTo(before + 1)
    expect(desk.work.table.rows).toHaveLength(10)
    expect(desk.work.state!.centres).toHaveLength(4)
  })

  test('collects three hundred readings and no more', () => {
    const desk = new Desk()
    desk.turnTo('readings')
    drives(desk, 310)
    expect(desk.work.table.rows).toHaveLength(300)
  })

  test.each([
    ['the device is switched off', () => {}],
    ['another page of the playground is opened', (desk: Desk) => desk.turnTo('things')],
    ['the playground is left', (desk: Desk) => desk.close()],
    ['the browser shows another tab', (desk: Desk) => desk.save()],
  ])('readings are there again when %s while Bo drives', (_, leave) => {
    const desk = new Desk()
    desk.turnTo('readings')
    drives(desk, 7)
    leave(desk)
    const again = new Desk()
    again.turnTo('readings')
    expect(again.work.table.rows).toHaveLength(7)
    expect(again.work.state!.centres).toHaveLength(3)
  })

  test('each page is found again as it was left, with its result', () => {
    const desk = new Desk()
    desk.takeSet('leaves')
    for (let step = 0; step < 100 && !desk.done; step++) desk.stepAll()
    const { state } = desk.work
    desk.turnTo('points')
    desk.takeTrap('moons')
    desk.turnTo('things')
    expect(desk.work).toMatchObject({ set: 'leaves', state })
    desk.turnTo('points')
    expect(desk.work.set).toBe('moons')
    desk.goTo(desk.at - 1)
    expect(desk.work.set).toBe('leaves')
  })

  test('what changed while it plays is saved when the page is hidden', () => {
    const desk = new Desk()
    desk.play()
    desk.count('colour', true)
    expect(new Desk().work.counting).not.toContain('colour')
    desk.save()
    expect(new Desk().work.counting).toContain('colour')
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
