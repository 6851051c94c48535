import { expect, test } from 'vitest'
import { knowMaps } from '@botgarten/blocks'
import { mapNames, stationsOf } from '../../blocks/parts/maps.ts'
import { content } from '../files.ts'

knowMaps((id) => content.stations[id] ?? 0)

test.each(mapNames)('the map that a block offers as %s is there', (name) => {
  expect(stationsOf(name)).toBeGreaterThan(1)
})

test('a map that is not there has no stations', () => {
  expect(stationsOf('MAP_MOON')).toBe(0)
})

test.each(content.languages)('every card is called something in "%s", and no two the same', (language) => {
  const titles = content.cards.map(({ title }) => title[language])
  expect(titles.filter((title) => !title)).toEqual([])
  expect(new Set(titles).size).toBe(titles.length)
})
