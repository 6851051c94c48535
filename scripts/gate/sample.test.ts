import { expect, test } from 'vitest'
import { isInSample, PARTS, partOf } from './sample.mjs'

const names = Array.from({ length: 200 }, (_, index) => `card-${index}`)
const parts = Array.from({ length: PARTS }, (_, part) => part)

test('each test is in one of four samples, so that four runs cover everything', () => {
  for (const name of names) expect(parts.filter((part) => isInSample(name, part))).toHaveLength(1)
})

test('each sample holds some of many tests', () => {
  for (const part of parts) expect(names.filter((name) => isInSample(name, part)).length).toBeGreaterThan(20)
})

test('a commit always has the same sample, and the number of a part is that part', () => {
  const commit = 'a62d0d78e2b7c8f1d2a3b4c5d6e7f8a9b0c1d2e3'
  expect(partOf(commit)).toBe(partOf(commit))
  expect(parts).toContain(partOf(commit))
  expect(parts.map(String).map(partOf)).toEqual(parts)
})
