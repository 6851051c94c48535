import { expect, test } from 'vitest'
import { knowMaps, knownMaps, mapField } from '@botgarten/blocks'
import { completeLanguages, tableOf } from '@botgarten/messages/folder'
import { content } from '../files.ts'

knowMaps(content)

test.each(completeLanguages)(
  'every map is called something in "%s", and no name is left over',
  (language) => {
    const names = Object.keys(tableOf('blocks-q-learning', language)).filter((key) =>
      key.startsWith('choice.MAP_'),
    )
    expect(names.toSorted()).toEqual(content.maps.map((id) => `choice.${mapField(id)}`).toSorted())
  },
)

test('blocks offer every map that is there, small ones first', () => {
  expect(knownMaps().toSorted()).toEqual(content.maps.toSorted())
  const sizes = knownMaps().map((id) => content.stations[id])
  expect(sizes).toEqual(sizes.toSorted((a, b) => a! - b!))
})

test.each(completeLanguages)('every card is called something in "%s", and no two the same', (language) => {
  const titles = content.cards.map(({ title }) => title[language])
  expect(titles.filter((title) => !title)).toEqual([])
  expect(new Set(titles).size).toBe(titles.length)
})
