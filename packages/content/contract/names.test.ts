import { expect, test } from 'vitest'
import { knowMaps, knownMaps } from '@botgarten/blocks'
import { content } from '../files.ts'

knowMaps(content)

test('blocks offer every map that is there, small ones first', () => {
  expect(knownMaps().toSorted()).toEqual(content.maps.toSorted())
  const sizes = knownMaps().map((id) => content.stations[id])
  expect(sizes).toEqual(sizes.toSorted((a, b) => a! - b!))
})

test.each(content.languages)('every card is called something in "%s", and no two the same', (language) => {
  const titles = content.cards.map(({ title }) => title[language])
  expect(titles.filter((title) => !title)).toEqual([])
  expect(new Set(titles).size).toBe(titles.length)
})
