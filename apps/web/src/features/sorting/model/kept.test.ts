import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { Playground } from './playground.svelte.ts'
import { othersIn, read, workOfReadings, writtenReadings, written, type Kept } from './kept.ts'
import type { Store } from './steps.svelte.ts'
import { fileTable, MOST_COLUMNS, MOST_FLAGS, MOST_POINTS, withTable } from './work.ts'

/** A store that goes through JSON, as files and devices do. */
function storeOf(kept: unknown = null): Store & { readonly now: () => unknown } {
  let now = kept
  return {
    kept,
    keep: (next) => (now = JSON.parse(JSON.stringify(next())) as unknown),
    flush: () => {},
    project: null,
    close: () => {},
    now: () => now,
  }
}

const whole = (): Kept => {
  const store = storeOf()
  const playground = new Playground(store)
  playground.takeTrap('heaps')
  playground.name(1, 'Heap')
  return store.now() as Kept
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
        const work = withTable({ ...workOfReadings([]), source: 'points' }, fileTable(names, rows))
        const again = read(JSON.parse(JSON.stringify(written(work))))
        expect(again && written(again)).toEqual(JSON.parse(JSON.stringify(written(work))))
      }),
    )
  })

  test('has a version, and comes back as it was', () => {
    const kept = whole()
    expect(kept.version).toBe(1)
    const again = new Playground(storeOf(kept))
    expect(written(again.work)).toEqual(kept)
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
    expect(kept).toMatchObject({ version: 1, source: 'readings' })
    expect(kept.pages!.map(({ source, set }) => [source, set])).toEqual([
      ['things', 'leaves'],
      ['points', 'heaps'],
    ])
    const again = new Playground(storeOf(kept))
    again.turnTo('points')
    expect([again.work.set, again.nameOf(1)]).toEqual(['heaps', 'Heap'])
    expect(writtenReadings([[1, 2, 3]], 'broken').pages).toBeUndefined()
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
    ['a newer version', { version: 2 }],
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
  ])('%s is not read: the playground begins again, and says so', (_, part) => {
    const playground = new Playground(storeOf({ ...whole(), ...part }))
    expect(playground.unread).toBe(true)
    expect(playground.work).toMatchObject({ source: 'things', set: 'vessels' })
  })

  test('whatever lies there, the playground opens and can be sorted', () => {
    const part = fc.oneof(fc.anything(), fc.constant(undefined))
    const kept = whole()
    const names = [...Object.keys(kept), 'pages']
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
