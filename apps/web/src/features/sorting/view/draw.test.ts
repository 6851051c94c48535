import { expect, test } from 'vitest'
import { coloured, stampOf, stampOnto, type Pixels } from './draw.ts'

const picture = (width: number, ...pixels: readonly (readonly number[])[]): Pixels => ({
  width,
  height: pixels.length / width,
  data: Uint8ClampedArray.from(pixels.flat()),
})
const stamp = (onto: Pixels, small: Pixels, x: number, y: number) =>
  stampOnto(onto, stampOf(small, onto.width), x, y)
const none = [0, 0, 0, 0]
const red = [200, 0, 0, 255]

test('a stamp lies where it is put, and lets through where it is clear', () => {
  const onto = picture(3, none, none, none, none, none, none)
  stamp(onto, picture(2, red, none), 1, 1)
  expect([...onto.data]).toEqual([none, none, none, none, red, none].flat())
})

test.each([
  [-1, 0],
  [1, 0],
  [0, -1],
  [0, 1],
  [9, 9],
])('what hangs over the rim at %i, %i is left out', (x, y) => {
  const onto = picture(2, none, none, none, none)
  stamp(onto, picture(2, red, red, red, red), x, y)
  expect([...onto.data].every((part) => part === 0)).toBe(true)
})

test('what is half clear mixes with what lies below, by the rule of Porter and Duff', () => {
  const onto = picture(1, [0, 100, 0, 255])
  stamp(onto, picture(1, [200, 0, 0, 51]), 0, 0)
  expect([...onto.data]).toEqual([40, 80, 0, 255])
  const clear = picture(1, [0, 100, 0, 102])
  stamp(clear, picture(1, [200, 0, 0, 51]), 0, 0)
  // 0.2 over 0.4: alpha 0.52; red 200 · 0.2 / 0.52, green 100 · 0.32 / 0.52
  expect([...clear.data]).toEqual([77, 62, 0, 133])
})

test('a shape in another colour keeps its edges', () => {
  const onto = picture(1, none)
  stampOnto(onto, coloured(stampOf(picture(1, [1, 2, 3, 77]), 1), [9, 8, 7]), 0, 0)
  expect([...onto.data]).toEqual([9, 8, 7, 77])
})
