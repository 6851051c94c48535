import { LARGEST } from '@botgarten/learning/k-means'
import fc from 'fast-check'
import { expect, test } from 'vitest'
import { mostOfSorting as most, sortingIn, sortingSources, type SortingDocument } from './index.ts'

const value = fc.double({ noNaN: true, min: -LARGEST, max: LARGEST }).map((one) => one + 0)
const finite = fc.double({ noNaN: true, noDefaultInfinity: true }).map((one) => one + 0)
const row = fc.array(value, { minLength: 1, maxLength: most.columns })
const rows = fc.array(row, { maxLength: 12 })
const flags = fc.array(row, { maxLength: most.flags })
const short = fc.string({ maxLength: most.column })
const whole = (min: number, max: number) => fc.integer({ min, max })
const axis = whole(-1, most.columns - 1)
const column = fc.record({
  feature: short,
  part: short,
  unit: short,
  low: finite,
  high: finite,
  scale: finite,
})
const run = fc.record({
  start: flags,
  phase: fc.constantFrom('assign' as const, 'move' as const, 'done' as const),
  round: whole(0, most.rounds),
  next: whole(0, most.points),
})
const page = fc.record(
  {
    source: fc.constantFrom(...sortingSources),
    set: short,
    counting: fc.array(short, { maxLength: most.columns }),
    columns: fc.array(column, { maxLength: most.columns }),
    rows,
    axes: fc.tuple(axis, axis),
    flags: whole(1, most.flags),
    distance: fc.constantFrom('euclidean' as const, 'manhattan' as const, 'cosine' as const),
    centres: flags,
    names: fc.array(fc.string({ maxLength: most.name }), { maxLength: most.flags }),
    run,
  },
  {
    requiredKeys: ['source', 'set', 'counting', 'columns', 'rows', 'flags', 'distance', 'centres', 'names'],
  },
)
const document: fc.Arbitrary<SortingDocument> = fc
  .tuple(page, fc.array(page, { maxLength: 4 }), fc.constantFrom(1 as const, 2 as const))
  .map(([shown, pages, version]) => ({ version, ...shown, ...(pages.length > 0 && { pages }) }))

const copy = (data: unknown): unknown => JSON.parse(JSON.stringify(data))

test('any playground comes back from a file the same', () => {
  fc.assert(
    fc.property(document, (one) => {
      expect(sortingIn(copy(one))).toEqual(copy(one))
    }),
  )
})

test('unknown keys are left out, at every level', () => {
  fc.assert(
    fc.property(document, fc.string(), (one, key) => {
      const extra = { [`x${key}`]: 1 }
      const more = { ...one, ...extra, columns: one.columns.map((column) => ({ ...column, ...extra })) }
      expect(sortingIn(copy(more))).toEqual(copy(one))
    }),
  )
})

test('whatever is in its place, the answer is a playground within its limits, or null', () => {
  fc.assert(
    fc.property(
      document,
      fc.constantFrom(
        'version',
        'source',
        'set',
        'columns',
        'rows',
        'axes',
        'flags',
        'centres',
        'run',
        'pages',
      ),
      fc.anything(),
      (one, key, other) => {
        const read = sortingIn({ ...one, [key]: other })
        if (read === null) return
        expect(sortingIn(copy(read))).toEqual(copy(read))
        for (const { rows, columns, flags } of [read, ...(read.pages ?? [])]) {
          expect(rows.length).toBeLessThanOrEqual(most.points)
          expect(columns.length).toBeLessThanOrEqual(most.columns)
          expect(flags).toBeLessThanOrEqual(most.flags)
          expect(rows.flat().every((number) => Math.abs(number) <= LARGEST)).toBe(true)
        }
      },
    ),
  )
})

const small: SortingDocument = {
  ...{ version: 1, source: 'points', set: '', counting: [], columns: [], rows: [[1, 2]], flags: 1 },
  ...{ distance: 'euclidean', centres: [[1, 2]], names: [] },
}
const many = <One>(count: number, one: One) => Array.from({ length: count }, () => one)

test.each([
  ['points', { rows: many(most.points, [1]) }, { rows: many(most.points + 1, [1]) }],
  ['values of a point', { rows: [many(most.columns, 1)] }, { rows: [many(most.columns + 1, 1)] }],
  ['flags', { flags: most.flags }, { flags: most.flags + 1 }],
  ['centres', { centres: many(most.flags, [1]) }, { centres: many(most.flags + 1, [1]) }],
  ['names', { names: many(most.flags, 'a') }, { names: many(most.flags + 1, 'a') }],
  ['letters of a name', { names: ['a'.repeat(most.name)] }, { names: ['a'.repeat(most.name + 1)] }],
  ['data sets', { pages: many(most.pages, small) }, { pages: many(most.pages + 1, small) }],
  ['a value', { rows: [[LARGEST]] }, { rows: [[LARGEST * 2]] }],
  ['a version', { version: 2 }, { version: 3 }],
])('%s: the most is read, one more is not', (_, most, more) => {
  expect(sortingIn({ ...small, ...most })).not.toBeNull()
  expect(sortingIn({ ...small, ...more })).toBeNull()
})
