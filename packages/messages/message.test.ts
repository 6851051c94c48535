import { expect, test } from 'vitest'
import { fill, type Message } from './message.ts'

const readings: Message = [
  {
    declarations: [
      'input count',
      'input groups',
      'local countPlural = count: plural',
      'local groupsPlural = groups: plural',
    ],
    selectors: ['countPlural', 'groupsPlural'],
    match: {
      'countPlural=one, groupsPlural=one': '{count} reading, {groups} group',
      'countPlural=one, groupsPlural=*': '{count} reading, {groups} groups',
      'countPlural=*, groupsPlural=*': '{count} readings, {groups} groups',
    },
  },
]

test('a placeholder is its fact, and stays where there is none', () => {
  expect(fill('{label} {place}', { label: 'Abstand' }, 'de')).toBe('Abstand {place}')
})

test('braces that are meant as braces have a backslash', () => {
  expect(fill('such as \\{"a": {value}\\}', { value: 1 }, 'en')).toBe('such as {"a": 1}')
})

test('a sentence has the form of its numbers; the first form that fits counts', () => {
  const said = (count: number, groups: number) => fill(readings, { count, groups }, 'en')
  expect(said(1, 1)).toBe('1 reading, 1 group')
  expect(said(1, 2)).toBe('1 reading, 2 groups')
  expect(said(0, 2)).toBe('0 readings, 2 groups')
})

test('every language has its own rules', () => {
  const days: Message = [
    {
      declarations: ['input days', 'local daysPlural = days: plural'],
      selectors: ['daysPlural'],
      match: {
        'daysPlural=one': '{days} den',
        'daysPlural=few': '{days} dny',
        'daysPlural=other': '{days} dní',
      },
    },
  ]
  // https://www.unicode.org/cldr/charts/latest/supplemental/language_plural_rules.html#cs
  expect([1, 2, 4, 5].map((days_) => fill(days, { days: days_ }, 'cs'))).toEqual([
    '1 den',
    '2 dny',
    '4 dny',
    '5 dní',
  ])
})

test('a number is written as in the language, with its groups of thousands', () => {
  const tries: Message = [
    {
      declarations: ['input count', 'local countPlural = count: plural', 'local countNumber = count: number'],
      selectors: ['countPlural'],
      match: { 'countPlural=one': 'ein Versuch', 'countPlural=other': '{countNumber} Versuche' },
    },
  ]
  expect([1, 1000].map((count) => fill(tries, { count }, 'de'))).toEqual(['ein Versuch', '1.000 Versuche'])
})
