import fc from 'fast-check'
import { expect, test } from 'vitest'
import { nearer, renewed } from './nearer.ts'

const keyOf = (one: number) => one
const lists = fc.uniqueArray(fc.integer({ min: 0, max: 200 }), { maxLength: 120 })

test('a list arrives at the one it follows, a few items at a time', () => {
  fc.assert(
    fc.property(lists, lists, (from, to) => {
      let list: readonly number[] = from
      for (let step = 0; step < 60; step += 1) {
        const next = nearer(list, to, keyOf)
        const [before, after] = [new Set(list), new Set(next)]
        expect(next.filter((one) => !before.has(one)).length).toBeLessThanOrEqual(6)
        expect(list.filter((one) => !after.has(one)).length).toBeLessThanOrEqual(6)
        list = next
      }
      expect(list).toEqual(to)
    }),
  )
})

test('what is there already is the wanted one at once: a knob goes with its weight', () => {
  const [old, fresh] = [
    { key: 1, at: 0 },
    { key: 1, at: 9 },
  ]
  expect(nearer([old], [fresh], ({ key }) => key)).toEqual([fresh])
})

test('while nothing comes or goes, what is there is as it is wanted, or the same list', () => {
  const [a, b, other] = [
    { key: 1, at: 0 },
    { key: 2, at: 0 },
    { key: 1, at: 9 },
  ]
  const byKey = ({ key }: { readonly key: number }) => key
  expect(renewed([a, b], [other], byKey)).toEqual([other, b])
  const list = [a, b]
  expect(renewed(list, [a], byKey)).toBe(list)
})
