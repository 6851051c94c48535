import { readItemText } from '@botgarten/content/items'
import { expect, test } from 'vitest'
import { headingOf, sidesOf, isWords, leavesOf, taskOf } from './sides.ts'

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

test('a heading says which task it is, where it begins with a number', () => {
  const tasks = ['2 Find your knobs', '3', '1.1 What is clever?', 'What do you think?'].map((title) =>
    taskOf(headingOf(title)),
  )
  expect(tasks).toEqual([{ number: '2', rest: 'Find your knobs' }, { number: '3', rest: '' }, null, null])
})
