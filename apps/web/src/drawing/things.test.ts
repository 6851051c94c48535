import { describe, expect, test } from 'vitest'
import { isPale, mix } from './colours.ts'
import { ahead, brickJoints, headingTo, radiusOf } from './things.ts'

describe('things', () => {
  test('rule 1: heading 0 is east and grows counter-clockwise', () => {
    const here = { x: 10, y: 10 }
    expect(headingTo(here, { x: 20, y: 10 })).toBe(0)
    expect(headingTo(here, { x: 10, y: 20 })).toBe(90)
    expect(headingTo(here, { x: 10, y: 0 })).toBe(270)
    expect(ahead(here, 180, 5).x).toBeCloseTo(5)
  })

  test('a rectangle lies inside the circle around it', () => {
    expect(radiusOf({ kind: 'rectangle', width: 30, height: 40 })).toBe(25)
    expect(radiusOf({ kind: 'circle', radius: 7 })).toBe(7)
  })

  test('the joints of a wall lie inside it, upright or not', () => {
    const numbers = (path: string) => path.match(/-?[\d.]+/g)!.map(Number)
    expect(Math.max(...numbers(brickJoints(12, 150)).map(Math.abs))).toBe(75)
    expect(brickJoints(50, 12).match(/M/g)).toHaveLength(8)
  })
})

describe('colours', () => {
  test('white and yellow rings need a dark outline, the others do not', () => {
    expect(['#FFFFFF', '#F7D118'].map(isPale)).toEqual([true, true])
    expect(['#2F9C95', '#F28C45', '#00642E', '#B30006', '#0057A6'].map(isPale)).toEqual(Array(5).fill(false))
  })

  test('are mixed channel by channel', () => {
    expect(mix('#000000', '#FFFFFF', 0.5)).toBe('#808080')
    expect(mix('#0057A6', '#FFFFFF', 0)).toBe('#0057A6')
  })
})
