import { expect, test } from 'vitest'
import { rateBounds, roundsBounds, typedNumber } from './typed.ts'

test.each([
  ['0', 0.0001],
  ['-3', 0.0001],
  ['5', 5],
  ['7', 5],
  ['0,02', 0.02],
  ['1e-3', 0.001],
  ['', 0.1],
  ['fast', 0.1],
  ['1e999', 0.1],
])('a learning speed of "%s" is %d', (text, rate) => expect(typedNumber(text, rateBounds, 0.1)).toBe(rate))

test.each([
  ['0', 1],
  ['1000000000', 100_000],
  ['12.6', 13],
  ['-1', 1],
  ['', 60],
  ['NaN', 60],
])('"%s" rounds are %d', (text, rounds) => expect(typedNumber(text, roundsBounds, 60)).toBe(rounds))
