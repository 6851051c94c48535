import fc from 'fast-check'
import { expect, test } from 'vitest'
import { dotsOf } from './picture.ts'

test('points lie as on the plane, with the number of the nearest flag', () => {
  const sorting = { axes: [1, 0], rows: [[1, 2], [9, 8]], centres: [[8, 8], [0, 0]] } // prettier-ignore
  expect(dotsOf({ sorting })).toEqual([
    { x: 2, y: 9, group: 1 },
    { x: 8, y: 1, group: 0 },
  ])
})

test('whatever a project has there, the picture is made of numbers', () => {
  fc.assert(
    fc.property(fc.dictionary(fc.constantFrom('axes', 'rows', 'centres'), fc.anything()), (sorting) => {
      for (const { x, y, group } of dotsOf({ sorting }))
        expect([x, y, group].every((value) => typeof value === 'number')).toBe(true)
    }),
  )
  expect(dotsOf({})).toEqual([])
})
