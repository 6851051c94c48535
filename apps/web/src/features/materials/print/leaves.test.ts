import { readItemText } from '@botgarten/content/items'
import { expect, test } from 'vitest'
import { isWords, leavesOf } from './leaves.ts'

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
