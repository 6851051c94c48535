import { readItemText } from '@botgarten/content/items'
import { expect, test } from 'vitest'
import { isWorkedWith, poseOn, slidesOf, turned } from './deck.ts'

const deck = slidesOf(
  readItemText(
    '# Deck\n\nBelow.\n\n## One\n\nWords.\n\n::world{id=garden}\n\n::page\n\n### Notes\n\nSay it.',
  ),
)

test('a deck has its title first, then a slide for every section', () => {
  expect(deck.map(({ title, first }) => [title, first])).toEqual([
    ['Deck', true],
    ['One', false],
  ])
})

test('what is drawn stands beside the words, and notes are on no slide', () => {
  const { words, shown, notes } = deck[1]!
  expect([words, shown, notes].map(({ length }) => length)).toEqual([1, 1, 1])
  expect(shown[0]).toMatchObject({ embed: { kind: 'world' } })
})

test('a picture stands beside the words, though it is written among them', () => {
  const [, { words, shown }] = slidesOf(
    readItemText('# Deck\n\n## One\n\nWords.\n\n![Flags](flags.svg)\n'),
  ) as [unknown, (typeof deck)[0]]
  expect([words, shown].map((nodes) => nodes.map(({ type }) => type))).toEqual([['paragraph'], ['image']])
})

test('a slide with a live lab or questions is worked with, one with a picture is not', () => {
  const slides = slidesOf(
    readItemText(
      '# Deck\n\n## Live\n\n::live{card=friendship file=solution}\n\n## Drawn\n\n::world{id=garden}\n',
    ),
  )
  expect(slides.map(isWorkedWith)).toEqual([false, true, false])
})

test('Bo greets on the first slide, thinks at a question and else cheers on every other slide', () => {
  const slide = (title: string, first = false) => ({ title, first, words: [], shown: [], notes: [] })
  expect(poseOn(slide('Who are you?', true), 1)).toBe('wave')
  expect(poseOn(slide('Who are you?'), 3)).toBe('think')
  expect([3, 4].map((number) => poseOn(slide('Off we go!'), number))).toEqual(['cheer', 'wave'])
})

test.each([
  ['ArrowRight', 3, 4],
  [' ', 3, 4],
  ['ArrowLeft', 3, 2],
  ['Home', 3, 0],
  ['End', 3, 9],
  ['ArrowRight', 9, 9],
  ['ArrowLeft', 0, 0],
  ['x', 3, null],
])('"%s" on slide %i leads to %s', (key, at, to) => {
  expect(turned(key, at, 10)).toBe(to)
})
