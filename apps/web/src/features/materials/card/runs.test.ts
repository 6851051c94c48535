import { readFileSync } from 'node:fs'
import { content } from '@botgarten/content/files'
import { expect, test } from 'vitest'
import { runsOf } from './runs.ts'

const wordsOf = (card: string) => readFileSync(content.path('cards', 'q-learning', card, 'en.md'), 'utf8')

test('the last run on Mars has as many tries as are enough there by its card', () => {
  const [, enough] = /(\d+) tries are enough on Mars/.exec(wordsOf('00-mars'))!
  expect(runsOf('mars', {})!.tries.at(-1)).toBe(Number(enough))
})

test('the runs on the railway have the tries that its card names', () => {
  const [, ...named] = /tries: (\d+), (\d+) or (\d+)/.exec(wordsOf('01-railway'))!
  expect(runsOf('railway', {})).toEqual({ tries: named.map(Number), waysBelow: false })
})

test('a card with a pay of its own has another table', () => {
  expect(runsOf('mars', { pay: { own: { '4': 1000 } } })).toBeNull()
})
