import { readItemText } from '@botgarten/content/items'
import { expect, test } from 'vitest'
import { sidesOf } from './sides.ts'

const kinds = (markdown: string) =>
  sidesOf(readItemText(markdown)).map((side) => side.map(({ type }) => type).join(' '))

test('a new side begins at every page, and an empty one is left out', () => {
  expect(kinds('# Title\n\nOne.\n\n::page\n\n## Two\n\n- three\n\n::page\n::page\n')).toEqual([
    'paragraph',
    'heading list',
  ])
})

test('the words of the teacher are on no side', () => {
  expect(kinds('# Title\n\n## Slide\n\nSeen.\n\n### Notes\n\nNot seen.\n')).toEqual(['heading paragraph'])
})
