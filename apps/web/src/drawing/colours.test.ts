import { expect, test } from 'vitest'
import { greyOf, heatOf } from './colours.ts'

/** Relative luminance (WCAG). */
const light = (colour: string) =>
  [1, 3, 5]
    .map((from) => parseInt(colour.slice(from, from + 2), 16) / 255)
    .map((part) => (part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4))
    .reduce((sum, part, index) => sum + part * [0.2126, 0.7152, 0.0722][index]!, 0)

test('the higher a value the darker its colour, so that it can be read in grey, and ink stays readable on it', () => {
  const ink = light('#3A2A20')
  for (const sign of [1, -1]) {
    const lights = Array.from({ length: 21 }, (_, step) => 5 * step).map((value) =>
      light(heatOf(sign * value)),
    )
    lights.slice(1).forEach((one, index) => expect(one).toBeLessThan(lights[index]!))
    expect((lights.at(-1)! + 0.05) / (ink + 0.05)).toBeGreaterThan(4.5)
  }
})

test('the heat goes from pale over gold to green, and no further', () => {
  expect([0, 50, 100, 200].map(heatOf)).toEqual(['#FFF6D8', '#F5C64A', '#6DBE76', '#6DBE76'])
})

test('grey is as bright as the colour was (CSS Filter Effects, grayscale)', () => {
  expect(['#FF0000', '#00FF00', '#0000FF', '#fff', '#123456'].map(greyOf)).toEqual([
    '#363636',
    '#b6b6b6',
    '#121212',
    '#ffffff',
    '#2f2f2f',
  ])
})
