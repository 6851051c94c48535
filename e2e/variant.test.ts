import { expect, test } from 'vitest'
import { content } from '@botgarten/content/files'
import { sampled, variants, variantsOf } from './variant.ts'

const samples = ['0', '1', '2', '3']

test('two languages and two hands are four variants, and all of them are walked without a sample', () => {
  expect(variants).toHaveLength(4)
  expect(variantsOf('fear', undefined)).toEqual(variants)
})

test.each(content.cards.map(({ id }) => id))(
  'a sample walks %s in one variant, and the four samples walk it in all of them',
  (card) => {
    for (const sample of samples) expect(variantsOf(card, sample)).toHaveLength(1)
    expect(new Set(samples.flatMap((sample) => variantsOf(card, sample)))).toEqual(new Set(variants))
  },
)

test('the four samples of a list contain each of its items once, and without a sample it is whole', () => {
  const ids = content.cards.map(({ id }) => id)
  expect(samples.flatMap((sample) => sampled(ids, sample)).toSorted()).toEqual(ids.toSorted())
  for (const sample of samples) expect(sampled(ids, sample).length).toBeGreaterThan(ids.length / 4 - 1)
  expect(sampled(ids, undefined)).toEqual(ids)
})

test('each sample holds every variant', () => {
  for (const sample of samples) {
    const walked = content.cards.flatMap(({ id }) => variantsOf(id, sample))
    expect(new Set(walked)).toEqual(new Set(variants))
  }
})
