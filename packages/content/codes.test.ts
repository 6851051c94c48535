import { expect, test } from 'vitest'
import { codeWords } from './codes.ts'

// Pairs of letters that are taken for each other on a board or by a child who writes from it.
const alike = ['ilj', 'mn', 'uvw', 'bdpq', 'ceo', 'sz', 'ft', 'gq', 'hn', 'ya']
const areAlike = (one: string, other: string) =>
  alike.some((group) => group.includes(one) && group.includes(other))

const distance = (one: string, other: string) => [...one].filter((letter, at) => letter !== other[at]).length
const onlyLooksDifferent = (one: string, other: string) =>
  distance(one, other) === 1 &&
  [...one].every((letter, at) => letter === other[at] || areAlike(letter, other[at]!))

test.each(['de', 'en'] as const)('the %s list has 1,024 words that any keyboard can write', (language) => {
  const words = codeWords(language)
  expect(words).toHaveLength(1024)
  expect(words.filter((word) => !/^[a-z]{4,9}$/.test(word))).toEqual([])
})

test.each(['de', 'en'] as const)(
  'four letters of a word of the %s list are enough, and look like no others',
  (language) => {
    const starts = codeWords(language).map((word) => word.slice(0, 4))
    expect(new Set(starts).size).toBe(1024)
    const pairs = starts.flatMap((one, at) => starts.slice(at + 1).map((other) => [one, other] as const))
    expect(pairs.filter(([one, other]) => onlyLooksDifferent(one, other))).toEqual([])
  },
)
