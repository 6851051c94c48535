import { cluster, plusPlusStart } from '@botgarten/learning/k-means'
import { stream } from '@botgarten/numbers'
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest'
import { Playground } from './playground.svelte.ts'
import type { SortingDocument } from '@botgarten/programs/sorting'
import { traps } from './traps.ts'
import { pointsIn } from './work.ts'

/** The document on the device. */
let saved: unknown = null
const keep = (next: () => SortingDocument) => (saved = JSON.parse(JSON.stringify(next())) as unknown)
/** The playground, opened once more. */
const opened = () => new Playground({ kept: saved, keep, flush: () => {}, close: () => {} })
beforeEach(() => {
  vi.useFakeTimers()
  saved = null
})
afterEach(() => void vi.useRealTimers())

describe('the sorting playground', () => {
  test('opens with things on the table and as many flags as are said', () => {
    const playground = opened()
    expect(playground.work).toMatchObject({ source: 'things', set: 'vessels', flags: 3 })
    expect(playground.work.state?.centres).toHaveLength(3)
  })

  test('plays to the end, and the line leads back to every step', () => {
    const playground = opened()
    playground.play()
    vi.advanceTimersByTime(60_000)
    expect(playground.done).toBe(true)
    expect(playground.playing).toBe(false)
    expect(playground.work.state!.labels.every((label) => label >= 0)).toBe(true)
    const { state } = playground.work
    playground.goTo(0)
    expect(playground.work.state!.labels.every((label) => label === -1)).toBe(true)
    for (let step = 0; step < 100 && !playground.done; step++) playground.stepAll()
    expect(playground.work.state).toEqual(state)
  })

  test('point by point and flag by flag comes to the same end', () => {
    const [one, all] = [opened(), opened()]
    for (let step = 0; step < 300 && !one.done; step++) one.stepOne()
    for (let step = 0; step < 100 && !all.done; step++) all.stepAll()
    expect(one.work.state).toEqual(all.work.state)
  })

  test('again is the same flags at their first places', () => {
    const playground = opened()
    const { centres } = playground.work.state!
    for (let step = 0; step < 100 && !playground.done; step++) playground.stepAll()
    expect(playground.work.state!.centres).not.toEqual(centres)
    playground.again()
    expect(playground.work.state!.centres).toEqual(centres)
    expect(playground.work.state!.round).toBe(0)
  })

  test('the criterion decides: other features, other groups; none at all sorts nothing', () => {
    const playground = opened()
    const groups = () => {
      playground.throwFlags('best')
      for (let step = 0; step < 100 && !playground.done; step++) playground.stepAll()
      return playground.work.state!.labels
    }
    const byShape = groups()
    playground.count('width', false)
    playground.count('height', false)
    expect(playground.work.state).toBeNull()
    playground.count('colour', true)
    expect(playground.work.table.columns).toHaveLength(3)
    const pairs = (labels: readonly number[]) => labels.map((a) => labels.map((b) => a === b))
    expect(pairs(groups())).not.toEqual(pairs(byShape))
  })

  test('sorts a table that was opened, also one whose points are all the same', () => {
    const playground = opened()
    const sorts = (names: string[], rows: number[][]) => {
      playground.takeTable(names, rows)
      expect(playground.work.table.rows).toHaveLength(rows.length)
      playground.play()
      vi.advanceTimersByTime(60_000)
      expect(playground.done).toBe(true)
    }
    const rows = [[1.5, 2, 7], [9.5, 8, 1], [1.25, 2.5, 6], [9, 9, 2]] // prettier-ignore
    sorts(['Länge', 'Breite', 'Höhe'], rows)
    expect(playground.work.table.columns[0]).toMatchObject({ feature: 'Länge' })
    sorts(['1', '2'], [[5, 5], [5, 5], [5, 5]]) // prettier-ignore
  })

  test('a table of one column has one axis, every other table two: its first two columns', () => {
    const playground = opened()
    const axesOf = (...row: number[]) => {
      playground.takeTable(row.map(String), [row, row])
      return playground.work.axes
    }
    expect([axesOf(1), axesOf(1, 2), axesOf(1, 2, 3)]).toEqual([[0, -1], [0, 1], [0, 1]]) // prettier-ignore
  })

  test('the best of ten throws has the least inertia of ten, not of nine or eleven', () => {
    const playground = opened()
    playground.takeTrap('many')
    playground.setFlags(6)
    for (let time = 0; time < 30; time += 1) {
      const { table, flags, distance, throws } = playground.work
      const dice = stream(throws, 'learn/sorting/flags')
      const ten = Array.from({ length: 10 }, () =>
        cluster(pointsIn(table), plusPlusStart(pointsIn(table), flags, distance, dice), distance),
      )
      const least = Math.min(...ten.map(({ inertia }) => inertia.at(-1)!))
      playground.throwFlags('best')
      const best = ten.find(({ inertia }) => inertia.at(-1) === least)!
      expect(playground.work.state!.centres).toEqual(best.centres)
    }
  })

  test('never has more flags than points, and none without points', () => {
    const playground = opened()
    playground.turnTo('points')
    playground.takeOwn()
    expect(playground.work.state).toBeNull()
    playground.stepAll()
    playground.addPoint(1, 1)
    playground.addPoint(9, 9)
    expect(playground.work.state!.centres.length).toBeLessThanOrEqual(2)
    playground.setFlags(6)
    expect(playground.work.flags).toBe(2)
    playground.removePoint(0)
    expect(playground.work.flags).toBe(1)
    playground.setFlags(0)
    expect(playground.work.flags).toBe(1)
  })

  test('points drawn one by one get three flags as soon as there are three', () => {
    const playground = opened()
    playground.takeOwn()
    const flags = [1, 3, 5, 7].map((at) => (playground.addPoint(at, at), playground.work.flags))
    expect(flags).toEqual([1, 2, 3, 3])
    playground.setFlags(2)
    playground.addPoint(9, 9)
    expect(playground.work.flags).toBe(2)
  })

  test('a drag of a flag is one step on the line', () => {
    const playground = opened()
    const before = playground.last
    for (const x of [1, 2, 3]) playground.placeFlag(0, [x, 4], true)
    playground.placeFlag(0, [5, 4], false)
    expect(playground.work.state!.centres[0]).toEqual([5, 4])
    expect(playground.last).toBe(before + 1)
  })

  const red = [255, 0, 0]
  const blue = [0, 0, 255]
  const drives = (playground: Playground, readings: number) => {
    for (let reading = 0; reading < readings; reading++) playground.collect([reading % 2 === 0 ? red : blue])
  }

  test('a page without anything on it shows nothing of the page before', () => {
    const playground = opened()
    playground.play()
    vi.advanceTimersByTime(60_000)
    expect(playground.done).toBe(true)
    playground.turnTo('readings')
    expect(playground.work).toMatchObject({ source: 'readings', state: null, flags: 3, table: { rows: [] } })
    expect(playground.done).toBe(false)
    playground.turnTo('points')
    playground.takeTrap('moons')
    playground.stepAll()
    playground.turnTo('readings')
    expect([playground.work.state, playground.work.axes]).toEqual([null, [0, 2]])
  })

  test('what Bo reads lies on the plane while it drives; flags come when it ends, and all of it is one step', () => {
    const playground = opened()
    playground.turnTo('readings')
    const before = playground.last
    drives(playground, 5)
    expect(playground.work.table.rows).toHaveLength(5)
    expect(playground.work.table.rows[0]).toEqual([10, 0, 0])
    expect(playground.work.state).toBeNull()
    playground.endCollecting()
    expect(playground.work.state!.centres).toHaveLength(3)
    expect(playground.last).toBe(before + 1)
    playground.goTo(before)
    expect(playground.work.table.rows).toEqual([])
  })

  test('a short drive that leaves no room for three flags does not keep them away for ever', () => {
    const playground = opened()
    playground.turnTo('readings')
    drives(playground, 1)
    playground.endCollecting()
    expect(playground.work.flags).toBe(1)
    drives(playground, 4)
    playground.endCollecting()
    expect(playground.work.flags).toBe(3)
    playground.setFlags(2)
    drives(playground, 4)
    playground.endCollecting()
    expect(playground.work.flags).toBe(2)
  })

  test('other flags while Bo drives are those of the drive; a step back ends it', () => {
    const playground = opened()
    playground.turnTo('readings')
    const before = playground.last
    drives(playground, 8)
    playground.setFlags(4)
    drives(playground, 2)
    expect(playground.collecting).toBe(true)
    playground.goTo(before)
    expect(playground.collecting).toBe(false)
    playground.goTo(before + 1)
    expect(playground.work.table.rows).toHaveLength(10)
    expect(playground.work.state!.centres).toHaveLength(4)
  })

  test('collects three hundred readings and no more', () => {
    const playground = opened()
    playground.turnTo('readings')
    drives(playground, 310)
    expect(playground.work.table.rows).toHaveLength(300)
  })

  test.each([
    ['the device is switched off', () => {}],
    ['another page of the playground is opened', (playground: Playground) => playground.turnTo('things')],
    ['the playground is left', (playground: Playground) => playground.close()],
    ['the browser shows another tab', (playground: Playground) => playground.save()],
  ])('readings are there again when %s while Bo drives', (_, leave) => {
    const playground = opened()
    playground.turnTo('readings')
    drives(playground, 7)
    leave(playground)
    const again = opened()
    again.turnTo('readings')
    expect(again.work.table.rows).toHaveLength(7)
    expect(again.work.state!.centres).toHaveLength(3)
  })

  test('a playground that is left while it plays saves its flags, plays no more, and closes its project', () => {
    const close = vi.fn()
    const playground = new Playground({ kept: null, keep, flush: () => {}, close })
    playground.play()
    vi.advanceTimersByTime(700)
    const { state } = playground.work
    playground.close()
    expect(close).toHaveBeenCalledOnce()
    vi.advanceTimersByTime(60_000)
    expect([playground.playing, playground.work.state]).toEqual([false, state])
    const again = new Playground({ kept: saved, keep, flush: () => {}, close })
    expect(again.work.state!.centres).toEqual(state!.centres)
  })

  test('each page is found again as it was left, with its result', () => {
    const playground = opened()
    playground.takeSet('leaves')
    for (let step = 0; step < 100 && !playground.done; step++) playground.stepAll()
    const { state } = playground.work
    playground.turnTo('points')
    playground.takeTrap('moons')
    playground.turnTo('things')
    expect(playground.work).toMatchObject({ set: 'leaves', state })
    playground.turnTo('points')
    expect(playground.work.set).toBe('moons')
    playground.goTo(playground.at - 1)
    expect(playground.work.set).toBe('leaves')
  })

  test('own points and an own table are there after a look at another data set, and both stay apart', () => {
    const playground = opened()
    playground.turnTo('points')
    playground.takeOwn()
    for (const at of [1, 3, 5]) playground.addPoint(at, at)
    playground.name(0, 'Mine')
    playground.takeTable(['a', 'b', 'c'], [[1, 2, 3], [4, 5, 6]]) // prettier-ignore
    playground.takeTrap('heaps')
    playground.removePoint(0)
    playground.takeOwn()
    expect(playground.work.table.rows).toEqual([[1, 1], [3, 3], [5, 5]]) // prettier-ignore
    expect(playground.nameOf(0)).toBe('Mine')
    playground.takeOwnTable()
    expect(playground.work.table.columns.map(({ feature }) => feature)).toEqual(['a', 'b', 'c'])
    playground.turnTo('things')
    playground.turnTo('points')
    expect([playground.work.set, playground.hasTable]).toEqual(['table', true])
  })

  test('drawn points are thrown away by their own button alone, and that can be taken back', () => {
    const playground = opened()
    playground.takeOwn()
    playground.addPoint(1, 1)
    playground.resetPoints()
    expect(playground.work.table.rows).toEqual([])
    playground.goTo(playground.at - 1)
    expect(playground.work.table.rows).toHaveLength(1)
    playground.takeTrap('heaps')
    playground.removePoint(0)
    playground.resetPoints()
    expect(playground.work).toMatchObject({ set: 'heaps', table: { rows: { length: 42 } } })
  })

  test('each set of things and points is found again with its result', () => {
    const playground = opened()
    const ends = [
      ['leaves', (on: Playground) => on.takeSet('leaves')],
      ['buttons', (on: Playground) => on.takeSet('buttons')],
      ['moons', (on: Playground) => on.takeTrap('moons')],
      ['outlier', (on: Playground) => on.takeTrap('outlier')],
    ] as const
    const results = ends.map(([, take]) => {
      take(playground)
      for (let step = 0; step < 100 && !playground.done; step++) playground.stepAll()
      return playground.work.state
    })
    for (const on of [playground, opened()])
      expect(ends.map(([, take]) => (take(on), on.work.state))).toEqual(results)
  })

  test('what changed while it plays is saved when the page is hidden', () => {
    const playground = opened()
    playground.play()
    playground.count('colour', true)
    expect(opened().work.counting).not.toContain('colour')
    playground.save()
    expect(opened().work.counting).toContain('colour')
  })

  test('is found again as it was left, with its names', () => {
    const playground = opened()
    playground.takeTrap('moons')
    playground.setFlags(4)
    playground.name(2, 'Half moon')
    const again = opened()
    expect(again.work.table).toEqual(playground.work.table)
    expect(again.work.state!.centres).toEqual(playground.work.state!.centres)
    expect(again.nameOf(2)).toBe('Half moon')
  })

  test.each([{ source: 'things', set: 'cars' }, [1, 2], { rows: [[null]] }, 'not json'])(
    'what is broken on the device is the first playground: %j',
    (kept) => {
      saved = kept
      expect(opened().work).toMatchObject({ source: 'things', set: 'vessels' })
    },
  )

  test.each(Object.keys(traps))('the trap %s lies on the plane and can be sorted', (name) => {
    const playground = opened()
    playground.takeTrap(name)
    for (const value of playground.work.table.rows.flat()) expect(value >= 0 && value <= 10).toBe(true)
    for (let step = 0; step < 200 && !playground.done; step++) playground.stepAll()
    expect(playground.done).toBe(true)
  })

  test.each([
    ['heaps', 3],
    ['few', 5],
  ])(
    'the %s are apart: points of one heap are nearer to each other than to any of another',
    (name, heaps) => {
      const rows = traps[name]!.rows()
      const each = rows.length / heaps
      const apart = { own: [] as number[], others: [] as number[] }
      for (const [a, one] of rows.entries())
        for (const [b, other] of rows.slice(0, a).entries()) {
          const isOwn = Math.floor(a / each) === Math.floor(b / each)
          apart[isOwn ? 'own' : 'others'].push(Math.hypot(one[0]! - other[0]!, one[1]! - other[1]!))
        }
      expect(Math.max(...apart.own)).toBeLessThan(Math.min(...apart.others))
    },
  )

  test('the five heaps are placed as on a die: those in the corners are equally far from the one in the middle', () => {
    const rows = traps['few']!.rows()
    const mean = (heap: number, axis: number) =>
      rows.slice(12 * heap, 12 * heap + 12).reduce((sum, row) => sum + row[axis]! / 12, 0)
    const far = [0, 1, 2, 3].map((heap) => Math.hypot(mean(heap, 0) - mean(4, 0), mean(heap, 1) - mean(4, 1)))
    expect(Math.max(...far) / Math.min(...far)).toBeLessThan(1.1)
  })

  test('moons are half circles: every point is about as far from the middle of both ends, on one side', () => {
    const rows = traps['moons']!.rows()
    for (const [arc, side] of [
      [rows.slice(0, 32), 1],
      [rows.slice(32), -1],
    ] as const) {
      // prettier-ignore
      const [first, last] = [arc[0]!, arc.at(-1)!]
      const [x, y] = [(first[0]! + last[0]!) / 2, (first[1]! + last[1]!) / 2]
      const radius = Math.hypot(first[0]! - x, first[1]! - y)
      for (const [right, up] of arc) {
        expect(Math.abs(Math.hypot(right! - x, up! - y) - radius)).toBeLessThan(0.6)
        expect(side * (up! - y)).toBeGreaterThan(-0.6)
      }
    }
  })

  test('moons are cut: k-means puts points of both arcs together', () => {
    const playground = opened()
    playground.takeTrap('moons')
    playground.throwFlags('best')
    for (let step = 0; step < 200 && !playground.done; step++) playground.stepAll()
    const { labels } = playground.work.state!
    const first = new Set(labels.slice(0, 32))
    const second = new Set(labels.slice(32))
    expect(first.size + second.size).toBeGreaterThan(2)
  })
})
