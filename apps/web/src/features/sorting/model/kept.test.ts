import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { Playground } from './playground.svelte.ts'
import { mostOfSorting, type SortingDocument } from '@botgarten/programs/sorting'
import { othersIn, read, workOfReadings, writtenReadings, written } from './kept.ts'
import type { Store } from './store.svelte.ts'
import { fileTable, MOST_COLUMNS, MOST_FLAGS, MOST_POINTS, withTable, type Work } from './work.ts'

/** A store that goes through JSON, as files and devices do. */
function storeOf(kept: unknown = null): Store & { readonly now: () => unknown } {
  let now = kept
  return {
    kept,
    keep: (next) => (now = JSON.parse(JSON.stringify(next())) as unknown),
    flush: () => {},
    close: () => {},
    now: () => now,
  }
}

const whole = (): SortingDocument => {
  const store = storeOf()
  const playground = new Playground(store)
  playground.takeTrap('heaps')
  playground.name(1, 'Heap')
  return store.now() as SortingDocument
}

describe('what a project keeps of the playground', () => {
  test('can be opened again, whatever table was read', () => {
    const name = fc.oneof(fc.string(), fc.constant('x'.repeat(5000)))
    const table = fc.integer({ min: 1, max: MOST_COLUMNS }).chain((columns) =>
      fc.record({
        names: fc.array(name, { minLength: columns, maxLength: columns }),
        rows: fc.array(
          fc.array(fc.double({ noNaN: true, min: -1e300, max: 1e300 }), {
            minLength: columns,
            maxLength: columns,
          }),
          { minLength: 1, maxLength: 20 },
        ),
      }),
    )
    fc.assert(
      fc.property(table, ({ names, rows }) => {
        const work = withTable(
          { ...workOfReadings([]), source: 'points', set: 'table' },
          fileTable(names, rows),
        )
        const again = read(JSON.parse(JSON.stringify(written(work))))
        expect(again && written(again)).toEqual(JSON.parse(JSON.stringify(written(work))))
      }),
    )
  })

  test('a table without columns has no axes, one with a single column has one', () => {
    const work = { ...workOfReadings([]), source: 'points', set: 'table' } as const
    expect(withTable(work, fileTable([], [])).axes).toEqual([-1, -1])
    expect(withTable(work, fileTable(['a'], [[1], [2]])).axes).toEqual([0, -1])
    expect(withTable(work, fileTable(['a', 'b'], [[1, 2]])).axes).toEqual([0, 1])
  })

  test('has a version, and comes back as it was', () => {
    const kept = whole()
    expect(kept.version).toBe(1)
    const again = new Playground(storeOf(kept))
    expect(written(again.work, othersIn(kept))).toEqual(kept)
    expect(again.unread).toBe(false)
    expect(again.nameOf(1)).toBe('Heap')
  })

  test('the axes that were chosen, too', () => {
    const store = storeOf()
    const playground = new Playground(store)
    playground.takeTable(
      ['a', 'b', 'c'],
      [
        [1, 2, 3],
        [4, 5, 7],
        [9, 8, 7],
      ],
    )
    playground.setAxis(0, 2)
    expect(new Playground(storeOf(store.now())).work.axes).toEqual([2, 1])
  })

  test('what Bo has collected lies on the plane by its colours', () => {
    const work = workOfReadings([
      [255, 0, 0],
      [250, 5, 0],
      [0, 0, 255],
    ])
    expect(work).toMatchObject({ source: 'readings', flags: 3, axes: [0, 2] })
    expect(read(JSON.parse(JSON.stringify(written(work))))?.table.rows[0]).toEqual([10, 0, 0])
  })

  test('readings from the lab leave the other pages as they are', () => {
    const store = storeOf(whole())
    const playground = new Playground(store)
    playground.turnTo('things')
    playground.takeSet('leaves')
    const kept = writtenReadings([[255, 0, 0]], store.now())
    expect(kept).toMatchObject({ version: 2, source: 'readings' })
    expect(kept.pages!.map(({ source, set }) => [source, set])).toEqual([
      ['points', 'heaps'],
      ['things', 'vessels'],
      ['things', 'leaves'],
    ])
    const again = new Playground(storeOf(kept))
    again.turnTo('points')
    expect([again.work.set, again.nameOf(1)]).toEqual(['heaps', 'Heap'])
    expect(writtenReadings([[1, 2, 3]], 'broken').pages).toBeUndefined()
  })

  /** Can a reader before version 2 of this document open it? */
  const isOfVersion1 = ({ version, source, pages = [] }: SortingDocument) =>
    version === 1 && new Set([source, ...pages.map((page) => page.source)]).size === pages.length + 1

  test('has the oldest version that can hold it; points of the product are in no other', () => {
    const store = storeOf()
    const playground = new Playground(store)
    playground.turnTo('points')
    expect(store.now()).toSatisfy(isOfVersion1)
    expect(store.now()).toMatchObject({ set: 'heaps', rows: { length: 42 } })
    playground.takeTrap('moons')
    expect(store.now()).toMatchObject({ version: 2, set: 'moons', columns: [], rows: [] })
    const again = new Playground(storeOf(store.now()))
    expect(again.work.table.rows).toHaveLength(64)
    again.removePoint(0)
    again.takeTrap('heaps')
    again.takeTrap('moons')
    expect(again.work.table.rows).toHaveLength(63)
  })

  test('own points and a table have one name in version 1, and are told apart by their columns', () => {
    const table = (names: string[]) => ({
      ...written({ ...workOfReadings([]), source: 'points' }),
      ...{ columns: names.map((feature) => ({ feature, part: '', unit: '', low: 0, high: 10, scale: 10 })) },
      ...{ rows: [[1, 2]], set: '' },
    })
    expect(read(table(['right', 'up']))?.set).toBe('')
    expect(read(table(['weight', 'height']))?.set).toBe('table')
  })

  test.each([0, 1, 5, 43, 44, 60, 500])(
    'after %i steps the groups, the sums of all rounds and the first flags are there again',
    (steps) => {
      const store = storeOf()
      const playground = new Playground(store)
      playground.turnTo('points')
      playground.setFlags(4)
      for (let step = 0; step < steps; step++) playground.stepOne()
      const again = new Playground(storeOf(store.now()))
      expect(again.work.state).toEqual(playground.work.state)
      playground.again()
      again.again()
      expect(again.work.state).toEqual(playground.work.state)
    },
  )

  test('whatever a child does, all data sets are there again with their groups', () => {
    const names = ['heaps', 'moons', 'few'] as const
    const act = fc.oneof(
      fc.constantFrom(...names).map((name) => (on: Playground) => on.takeTrap(name)),
      fc.constantFrom('leaves', 'buttons', 'vessels').map((set) => (on: Playground) => on.takeSet(set)),
      fc.constant((on: Playground) => on.takeOwn()),
      fc.tuple(fc.nat(10), fc.nat(10)).map(([x, y]) => (on: Playground) => {
        if (on.work.source === 'points') on.addPoint(x, y)
      }),
      fc.nat(9).map((point) => (on: Playground) => {
        if (on.work.source === 'points') on.removePoint(point)
      }),
      fc.constant((on: Playground) => on.stepOne()),
      fc.constant((on: Playground) => on.stepAll()),
      fc.constant((on: Playground) => on.throwFlags('random')),
      fc.integer({ min: 1, max: 6 }).map((flags) => (on: Playground) => on.setFlags(flags)),
      fc.constant((on: Playground) => on.goTo(on.at - 1)),
      fc.tuple(fc.nat(5), fc.string()).map(
        ([group, name]) =>
          (on: Playground) =>
            on.name(group, name),
      ),
    )
    const shown = ({ source, set, table, names, state, flags }: Work) => ({
      ...{ source, set, names, state, flags },
      rows: table.rows,
    })
    fc.assert(
      fc.property(fc.array(act, { maxLength: 40 }), (acts) => {
        const store = storeOf()
        const playground = new Playground(store)
        playground.takeTrap('heaps')
        for (const act of acts) act(playground)
        const again = new Playground(storeOf(store.now()))
        expect(shown(again.work)).toEqual(shown(playground.work))
        for (const on of [playground, again]) on.takeOwn()
        expect(shown(again.work)).toEqual(shown(playground.work))
        for (const name of names) {
          for (const on of [playground, again]) on.takeTrap(name)
          expect(again.work.table).toEqual(playground.work.table)
        }
      }),
      { numRuns: 100 },
    )
  })

  test('a page that cannot be read takes no other page with it', () => {
    const other = {
      ...whole(),
      pages: [
        { ...whole(), source: 'things', set: 'cars' },
        { ...whole(), set: 'moons' },
      ],
    }
    expect(othersIn(other).map(({ set }) => set)).toEqual(['moons'])
    expect(read(other)?.set).toBe('heaps')
  })

  const row = [1, 2]
  test.each([
    ['a newer version', { version: 3 }],
    ['another source', { source: 'clouds' }],
    ['a set that nobody has', { source: 'things', set: 'cars' }],
    ['too many points', { rows: Array.from({ length: MOST_POINTS + 1 }, () => row) }],
    ['rows wider than a table', { rows: [Array.from({ length: MOST_COLUMNS + 1 }, () => 1)] }],
    ['rows of unequal length', { rows: [row, [1]] }],
    ['a number that is none', { rows: [[1, null]] }],
    ['a number without end', { rows: [[1, Infinity]] }],
    ['a number whose square has none', { rows: [[1, 1e141]] }],
    ['no flag', { flags: 0 }],
    ['half a flag', { flags: 1.5 }],
    ['too many flags', { flags: MOST_FLAGS + 1 }],
    ['a name without end', { names: ['x'.repeat(25)] }],
    ['too many names', { names: Array.from({ length: MOST_FLAGS + 1 }, () => 'x') }],
    ['a distance that nobody knows', { distance: 'far' }],
    ['an axis that is none', { axes: [0, 99] }],
    ['rounds without end', { run: { start: [row], phase: 'done', round: 1e9, next: 0 } }],
    ['too many data sets', { pages: Array.from({ length: mostOfSorting.pages + 1 }, () => whole()) }],
  ])('%s is not read: the playground begins again, and says so', (_, part) => {
    const playground = new Playground(storeOf({ ...whole(), ...part }))
    expect(playground.unread).toBe(true)
    expect(playground.work).toMatchObject({ source: 'things', set: 'vessels' })
  })

  test('whatever lies there, the playground opens and can be sorted', () => {
    const part = fc.oneof(fc.anything(), fc.constant(undefined))
    const kept = whole()
    const names = [...Object.keys(kept), 'pages', 'run']
    fc.assert(
      fc.property(fc.constantFrom(...names), part, (name, value) => {
        const playground = new Playground(storeOf({ ...kept, [name]: value }))
        for (let step = 0; step < 5; step++) playground.stepAll()
        expect(playground.work.flags).toBeGreaterThan(0)
      }),
      { seed: 8, numRuns: 300 },
    )
  })
})

test('all letters of a name are one step, and can be taken back', () => {
  const playground = new Playground(storeOf())
  const before = playground.last
  for (const name of ['B', 'Bo', 'Bot']) playground.name(0, name)
  expect(playground.last).toBe(before + 1)
  playground.name(1, 'C')
  expect(playground.last).toBe(before + 2)
  playground.goTo(before + 1)
  expect([playground.nameOf(0), playground.nameOf(1)]).toEqual(['Bot', ''])
  playground.goTo(before)
  expect(playground.nameOf(0)).toBe('')
})
