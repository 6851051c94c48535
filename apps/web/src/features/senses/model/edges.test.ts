import { expect, test } from 'vitest'
import { edgeAt, edgeByKey, roomOf } from './edges.ts'

test('an edge is a whole number, at least 1 from the ends and from the other edge', () => {
  expect(edgeAt('LOW', [15, 40], 22.4)).toBe(22)
  expect(edgeAt('LOW', [15, 40], -8)).toBe(1)
  expect(edgeAt('LOW', [15, 40], 70)).toBe(39)
  expect(edgeAt('HIGH', [15, 40], 3)).toBe(16)
  expect(edgeAt('HIGH', [15, 40], 1e9)).toBe(99)
  expect(roomOf('HIGH', [15, 40])).toEqual({ least: 16, most: 99 })
})

test('arrows move it by 1, pages by 10, Home and End as far as it goes, and other keys not at all', () => {
  const by = (key: string) => edgeByKey('LOW', [15, 40], key)
  expect(['ArrowRight', 'ArrowLeft', 'PageUp', 'PageDown', 'Home', 'End'].map(by)).toEqual([
    16, 14, 25, 5, 1, 39,
  ])
  expect(by('Enter')).toBeNull()
  expect(by('toString')).toBeNull()
})
