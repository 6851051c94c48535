import { defaultConfig } from '@botgarten/simulation'
import { expect, test } from 'vitest'
import { drawBo, partAt, partsOf } from './bo.ts'
import type { Command } from './commands.ts'

const parts = partsOf(defaultConfig)
const look = { config: defaultConfig, led: null, text: false }
const all = (shapes: readonly Command[]): readonly Command[] =>
  shapes.flatMap((shape) => [shape, ...(shape.kind === 'group' ? all(shape.shapes) : [])])
const count = (shapes: readonly Command[], fill: string) =>
  all(shapes).filter((shape) => 'fill' in shape && shape.fill === fill).length

test('wheels, eyes and the lamp are parts that can be pointed at', () => {
  expect(parts.map(({ part }) => part)).toEqual(
    expect.arrayContaining(['motor B', 'motor C', 'sensor 3', 'sensor 4', 'lamp']),
  )
})

test('every part is found at its middle, whatever the scale', () => {
  for (const scale of [1, 2.6, 8])
    for (const { part, x, y } of parts)
      expect(partAt(defaultConfig, scale, { x: x * scale, y: y * scale })).toBe(part)
})

test('a fingertip reaches 14 px around a part and no further', () => {
  const lamp = parts.find(({ part }) => part === 'lamp')!
  const below = (px: number) => ({ x: lamp.x * 8, y: (lamp.y + lamp.radius) * 8 + px })
  expect(partAt(defaultConfig, 8, below(13.9))).toBe('lamp')
  expect(partAt(defaultConfig, 8, below(14.1))).toBeNull()
})

test('a part that lights up has a halo, and only that', () => {
  expect(count(drawBo(look), '#FFC83D')).toBe(0)
  for (const { part } of parts)
    expect(count(drawBo({ ...look, lights: (one) => one === part }), '#FFC83D')).toBe(1)
})

test('the lamp highlighted in its colour, and the display shows a heart or lines', () => {
  expect(count(drawBo({ ...look, led: 'green' }), '#2FB457')).toBe(2)
  expect(count(drawBo(look), '#FF7E62')).toBe(1)
  expect(count(drawBo({ ...look, text: true }), '#FF7E62')).toBe(0)
})
