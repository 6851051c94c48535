import { expect, it } from 'vitest'
import { judged, measuresOf, type Cheat } from './measures.ts'

const measured = { cm: 10, tiles: 1, touching: 0, bumps: 0, free: 0, near: 0, line: 0, ended: 0 }
const spinner: Cheat = { cm: [0, 60], bumps: [0, 0] }

it('a cheat is known by all its measures, both ends included', () => {
  expect(judged(spinner, measured)).toBe(true)
  expect(judged(spinner, { ...measured, cm: 60 })).toBe(true)
  expect(judged(spinner, { ...measured, cm: 60.1 })).toBe(false)
  expect(judged(spinner, { ...measured, bumps: 1 })).toBe(false)
})

it('measures are rounded to tenths, ways are those of both directions', () => {
  const none = { bump: 0, moment: 0, ahead: 0, way: 0, wheels: 0, farther: 0, open: 0, near: 0, tile: 0 }
  const facts = { ...none, black: 0, line: 0, free: 0, way: 12.34, ahead: -12.34 }
  expect(measuresOf({ facts, tiles: 1.25, touching: 33.333, ended: 1 })).toEqual({
    ...{ cm: 12.3, tiles: 1.3, touching: 33.3, bumps: 0, free: 0, near: 0, line: 0, ended: 1 },
  })
})
