import { expect, test } from 'vitest'
import { mapNames, stationsOf } from '../../blocks/parts/maps.ts'
import { content } from '../files.ts'

// What code and words repeat of content/ is what stands there.
test.each(mapNames)('the block offers %s with as many stations as its map has', (name) => {
  const map = content.mapFile(name.replace('MAP_', '').toLowerCase())
  expect(stationsOf(name)).toBe(map?.map.moves.length)
})

test.each(content.languages)('every card is called something in "%s", and no two the same', (language) => {
  const titles = content.cards.map(({ title }) => title[language])
  expect(titles.filter((title) => !title)).toEqual([])
  expect(new Set(titles).size).toBe(titles.length)
})
