import type { Block } from '@botgarten/blocks'
import { toolbox } from '@botgarten/blocks'
import { completeLanguages } from '@botgarten/messages/folder'
import { describe, expect, it } from 'vitest'
import { content } from '../files.ts'
import { wordsIn } from './there.ts'

// The eight cards of the network give fewer and fewer blocks: what is missing the child builds, and the hints say from where.
const eight = content.cards
  .filter(({ bed }) => bed === 'network')
  .map(({ id }) => id)
  .slice(0, 8)

function* blocksIn(block: Block): Generator<string> {
  // Numbers come with their blocks.
  if (block.type !== 'math_number') yield block.type
  for (const value of Object.values(block.values ?? {})) yield* blocksIn(value)
  for (const one of Object.values(block.statements ?? {}).flat()) yield* blocksIn(one)
}

/** The types of a program's blocks, one an entry for each block. */
const blocksOf = (card: string, file: string): string[] =>
  content
    .program(card, file)!
    .programs['main']!.stacks.flatMap(({ blocks }) => blocks.flatMap((block) => [...blocksIn(block)]))

const categoryOf = (type: string) =>
  toolbox.find(({ blocks }) => blocks.some((block) => block.type === type))?.category

const wordsOf = (node: unknown): string =>
  Array.isArray(node)
    ? node.map(wordsOf).join('')
    : ((node as { value?: string }).value ?? wordsOf((node as { children?: unknown[] }).children ?? []))

describe('the blocks that the eight cards give', () => {
  it('are the eight of the table, in their order', () => {
    expect(eight).toEqual([
      ...['chameleon', 'incognito', 'caution', 'loud-distance'],
      ...['friendship', 'fear', 'interest', 'rally'],
    ])
  })

  it('are never more than those of the card before, and far fewer in the end', () => {
    const given = eight.map((card) => blocksOf(card, 'start').length)
    expect(given).toEqual(given.toSorted((a, b) => b - a))
    expect(given.at(-1)!).toBeLessThan(given[0]! / 2)
  })

  describe.each(eight)('%s', (card) => {
    const given = blocksOf(card, 'start')
    const { network } = content.card(card)!.card
    // "Put a network in" makes these.
    const made = network
      ? [
          'ai_neural_network',
          'ai_easy_list',
          ...[...network.inputs, ...network.outputs].map(({ type }) => type),
        ]
      : []
    const missing = [...new Set(blocksOf(card, 'solution'))].filter(
      (type) => !given.includes(type) && !made.includes(type),
    )

    it('gives nothing that the solution does without', () => {
      const solution = blocksOf(card, 'solution')
      const count = (types: readonly string[], type: string) => types.filter((one) => one === type).length
      expect(given.filter((type) => count(given, type) > count(solution, type))).toEqual([])
    })

    it.each(completeLanguages)(
      'says in "%s" how its network is made, and under which word every other kind of block is found',
      (language) => {
        const category = wordsIn(language, 'category')
        const said = wordsOf(content.card(card)!.text[language]!.hints)
        const { putOne } = wordsIn(language, 'network') as unknown as { readonly [key: string]: string }
        if (network) expect(said).toContain(putOne)
        for (const type of missing) expect(said).toContain(category[categoryOf(type)!])
      },
    )
  })
})
