import { completeLanguages, wordsOf } from '@botgarten/messages/folder'
import { sample } from '@botgarten/numbers/testing'
import { describe, expect, it } from 'vitest'
import { content } from '../files.ts'
import type { CardProgram, MarkdownNode } from '../index.ts'
import { practised } from './practised.ts'
import { solved } from './solved.ts'

const brainOf = (id: string, file: string) => Object.values(content.program(id, file)!.brains)[0]

/** Cards whose solution has practised its examples. */
const learnedCards = content.cards
  .map(({ id }) => id)
  .filter((id) => (brainOf(id, 'solution')?.practice?.round ?? 0) > 0)

const seeds = sample(
  Array.from({ length: 20 }, (_, k) => k + 1),
  1,
)

const withPractice = (id: string, seed: number) => (program: CardProgram) => ({
  ...program,
  brains: Object.fromEntries(
    Object.keys(program.brains).map((key) => [key, practised(id, program, seed).brain]),
  ),
})

/** What is printed bold, wherever it stands. */
const boldIn = (nodes: readonly MarkdownNode[]): readonly string[] =>
  nodes.flatMap((node) => {
    const inside = 'children' in node ? node.children : []
    return node.type === 'strong' ? [plain(inside)] : boldIn(inside)
  })
const plain = (nodes: readonly MarkdownNode[]): string =>
  nodes
    .map((node) => ('children' in node ? plain(node.children) : 'value' in node ? node.value : ''))
    .join('')

/** What the screen writes on its buttons and switches: without what stands in brackets, and without numbers. */
const labelsIn = (language: string) =>
  new Set(
    Object.values(wordsOf(language)).flatMap((message) =>
      typeof message === 'string' ? [message.replace(/\s*[({:].*$/, '').toLowerCase()] : [],
    ),
  )

describe.each(learnedCards)('the card %s is learned from examples', (id) => {
  const { card, text } = content.card(id)!
  const places = [...card.starts.keys()]

  it('lies in the chapter of examples on the home page', () => expect(card.chapter).toBe('examples'))

  it('its solution has the weights that its own examples and seed come to', () => {
    const program = content.program(id, 'solution')!
    const { weights, practice } = brainOf(id, 'solution')!
    expect(practised(id, program, practice!.seed).brain.weights).toEqual(weights)
  })

  it('with at least 19 of 20 seeds Bo passes from every place', () => {
    const failing = seeds.filter((seed) => {
      const { failures } = solved(id, withPractice(id, seed))
      return places.some((place) => failures(place, 1, {}).length > 0)
    })
    expect(failing.length).toBeLessThanOrEqual(seeds.length / 20)
  })

  it('every check can fail: a typical wrong answer misses it', () => {
    const missed = content.wrongAnswers(id).flatMap((name) => {
      const wrong = content.program(id, `wrong/${name}`)!
      const { failures } = solved(id, () => wrong)
      return sample(places, 1).flatMap((place) => failures(place, 1, {}))
    })
    expect(card.checks.filter((check) => !missed.includes(check.id))).toEqual([])
  })

  it.each(completeLanguages)('what is bold in its hints stands on the screen, in "%s"', (language) => {
    const labels = labelsIn(language)
    const bold = text[language]!.hints.flatMap((hint) => boldIn(hint))
    expect(bold.length).toBeGreaterThan(2)
    expect(bold.filter((words) => !labels.has(words.toLowerCase()))).toEqual([])
  })
})

it('blocks alone drive past both places of the card who-knows, and do not solve it', () => {
  const without = content.program('who-knows', 'wrong/without-network')!
  const { card, failures } = solved('who-knows', () => without)
  for (const place of card.starts.keys()) expect(failures(place, 1, {})).toEqual(['netDecides'])
})
