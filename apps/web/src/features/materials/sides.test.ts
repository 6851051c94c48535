import { readItemText } from '@botgarten/content/items'
import { expect, test } from 'vitest'
import { sidesOf, isWords, leavesOf } from './sides.ts'

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

const deck = readItemText(
  [
    '# Title',
    'Module 1',
    '## Words',
    '- one',
    '## Picture',
    'Look.',
    '![A flag](flag.svg)',
    '## Net',
    '::net{card=fear file=start}',
  ].join('\n\n'),
)

test('a slide of paragraphs and lists is words alone; one with a picture or a drawing is not', () => {
  const slides = leavesOf(deck, '16:9')
  expect(slides.map(({ title, nodes }) => [title, nodes.every(isWords)])).toEqual([
    ['Title', true],
    ['Words', true],
    ['Picture', false],
    ['Net', false],
  ])
})
