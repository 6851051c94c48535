import { expect, test } from 'vitest'
import { mapNames, stationsOf } from '../../blocks/parts/maps.ts'
import { content } from '../files.ts'
import { wordsIn } from './there.ts'

// What code and words repeat of content/ is what stands there.
test.each(mapNames)('the block offers %s with as many stations as its map has', (name) => {
  const map = content.mapFile(name.replace('MAP_', '').toLowerCase())
  expect(stationsOf(name)).toBe(map?.map.moves.length)
})

test.each(content.languages)(
  'every card is called in "%s" on the home page as in its own text',
  (language) => {
    const home = wordsIn(language, 'home')
    const titles = content.cards.map(({ id, title }) => [id, title[language]])
    expect(content.cards.map(({ id }) => [id, home[id]])).toEqual(titles)
  },
)
