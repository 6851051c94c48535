import { globSync, readFileSync } from 'node:fs'
import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { writeNumber } from '@botgarten/messages'
import { decimalMark, formatNumber, parseWeight } from './numbers.ts'
import { unitScale } from './track.ts'

const parsed = (text: string) => parseWeight(text, unitScale)

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
    expect(['0.8', '0,8', '.5', '1', '3', ' 0,25 ', '0.'].map(parsed)).toEqual([0.8, 0.8, 0.5, 1, 1, 0.25, 0])
  })

  test('is null where it is no number', () => {
    expect(['', '.', ',', 'a', '1e3', '-1', '0,8,1', '½'].map(parsed)).toEqual(Array(8).fill(null))
  })

  test('on a wider scale may be negative, with either minus, and is cut to its ends', () => {
    const wide = { least: -1, most: 1, unit: 1 } as const
    expect(['-0,5', '−0.25', '-3', '7', '-'].map((text) => parseWeight(text, wide))).toEqual([
      -0.5,
      -0.25,
      -1,
      1,
      null,
    ])
  })

  test('on a scale from 0 to 10 counts tenths', () => {
    const tens = { ...unitScale, unit: 10 } as const
    expect(['8', '10', '2,5', '30'].map((text) => parseWeight(text, tens))).toEqual([0.8, 1, 0.25, 1])
  })

  test('what is shown can be typed, in both languages', () => {
    fc.assert(
      fc.property(fc.integer({ min: 0, max: 100 }), fc.constantFrom('de', 'en'), (part, locale) => {
        expect(parsed(formatNumber(part / 100, locale))).toBe(part / 100)
      }),
    )
  })
})

test('every language has its own mark before the tenths', () => {
  expect(['de', 'en', 'fr', 'de-CH'].map(decimalMark)).toEqual([',', '.', ',', '.'])
})

describe('a value that is no number', () => {
  test.each([NaN, Infinity, -Infinity])('%s is a dash, in every form', (value) => {
    expect([formatNumber(value, 'de'), writeNumber(value, 'en', { least: 1, plus: true })]).toEqual([
      '–',
      '–',
    ])
  })
})

test('every number has a real minus, groups of thousands and no minus before zero', () => {
  expect(writeNumber(-4311.5, 'de')).toBe('−4.311,5')
  expect(writeNumber(-4311.5, 'en')).toBe('−4,311.5')
  expect([writeNumber(-0.001, 'en', { most: 1 }), writeNumber(2, 'en', { plus: true })]).toEqual(['0', '+2'])
})

test('every number of the web app is written by writeNumber; dates have formats of their own', () => {
  const root = `${import.meta.dirname}/..`
  const own = globSync('**/*.{ts,svelte}', { cwd: root }).filter((file) => {
    const text = readFileSync(`${root}/${file}`, 'utf8')
    return !file.endsWith('test.ts') && /NumberFormat\(|\.toLocaleString\((?![^)]*dateStyle)/.test(text)
  })
  expect(own).toEqual([])
})
