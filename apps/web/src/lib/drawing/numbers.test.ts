import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { formatNumber, parseWeight } from './numbers.ts'

describe('numbers a child reads', () => {
  test('have no trailing zeros and the comma of the language', () => {
    expect(formatNumber(0.8, 'de')).toBe('0,8')
    expect(formatNumber(0.8, 'en')).toBe('0.8')
    expect(formatNumber(0.25, 'de')).toBe('0,25')
    expect(formatNumber(1, 'de')).toBe('1')
    expect(formatNumber(1234.5, 'de')).toBe('1234,5')
  })

  test('are never minus zero, and minus is a minus sign', () => {
    expect(formatNumber(-0.001, 'en')).toBe('0')
    expect(formatNumber(-40, 'en')).toBe('−40')
  })
})

describe('a typed weight', () => {
  test('is read with dot or comma and cut to 0..1', () => {
    expect(['0.8', '0,8', '.5', '1', '3', ' 0,25 ', '0.'].map(parseWeight)).toEqual([
      0.8, 0.8, 0.5, 1, 1, 0.25, 0,
    ])
  })

  test('is null where it is no number', () => {
    expect(['', '.', ',', 'a', '1e3', '-1', '0,8,1', '½'].map(parseWeight)).toEqual(Array(8).fill(null))
  })

  test('what is shown can be typed, in both languages', () => {
    fc.assert(
      fc.property(fc.integer({ min: 0, max: 100 }), fc.constantFrom('de', 'en'), (part, locale) => {
        expect(parseWeight(formatNumber(part / 100, locale))).toBe(part / 100)
      }),
    )
  })
})
