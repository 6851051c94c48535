import { globSync, readFileSync } from 'node:fs'
import { basename, dirname, join } from 'node:path'
import type { Block } from '@botgarten/blocks'
import { toolbox } from '@botgarten/blocks'
import { describe, expect, it } from 'vitest'
import { readCard, readCardText, type CardProgram } from './index.ts'

// The eight cards of the network give fewer and fewer blocks: what is missing the child builds, and the hints say from where.
const content = join(import.meta.dirname, '../../content')
const read = (...path: string[]): unknown => JSON.parse(readFileSync(join(...path), 'utf8'))

const eight = globSync(join(content, 'cards/network/*/card.json')).sort().map(dirname).slice(0, 8)
const languages = globSync(join(content, 'words/*/app.json')).map((file) => basename(dirname(file)))

function* blocksIn(block: Block): Generator<string> {
  // Numbers come with their blocks.
  if (block.type !== 'math_number') yield block.type
  for (const value of Object.values(block.values ?? {})) yield* blocksIn(value)
  for (const one of Object.values(block.statements ?? {}).flat()) yield* blocksIn(one)
}

/** The types of a program's blocks, one an entry for each block. */
const blocksOf = (folder: string, file: string): string[] =>
  (read(folder, file) as CardProgram).programs['main']!.stacks.flatMap(({ blocks }) =>
    blocks.flatMap((block) => [...blocksIn(block)]),
  )

const categoryOf = (type: string) =>
  toolbox.find(({ blocks }) => blocks.some((block) => block.type === type))?.category

const wordsOf = (node: unknown): string =>
  Array.isArray(node)
    ? node.map(wordsOf).join('')
    : ((node as { value?: string }).value ?? wordsOf((node as { children?: unknown[] }).children ?? []))

describe('the blocks that the eight cards give', () => {
  it('are the eight of the table, in their order', () => {
    expect(eight.map((folder) => readCard(read(folder, 'card.json')).id)).toEqual([
      ...['chameleon', 'incognito', 'caution', 'loud-distance'],
      ...['friendship', 'fear', 'interest', 'rally'],
    ])
  })

  it('are never more than those of the card before, and far fewer in the end', () => {
    const given = eight.map((folder) => blocksOf(folder, 'start.json').length)
    expect(given).toEqual(given.toSorted((a, b) => b - a))
    expect(given.at(-1)!).toBeLessThan(given[0]! / 2)
  })

  describe.each(eight)('%s', (folder) => {
    const given = blocksOf(folder, 'start.json')
    const missing = [...new Set(blocksOf(folder, 'solution.json'))].filter((type) => !given.includes(type))

    it('gives nothing that the solution does without', () => {
      const solution = blocksOf(folder, 'solution.json')
      const count = (types: readonly string[], type: string) => types.filter((one) => one === type).length
      expect(given.filter((type) => count(given, type) > count(solution, type))).toEqual([])
    })

    it.each(languages)('says in "%s" under which word every other kind of block is found', (language) => {
      const { category } = read(content, 'words', language, 'app.json') as {
        category: Record<string, string>
      }
      const { hints } = readCardText(readFileSync(join(folder, `${language}.md`), 'utf8'))
      const said = wordsOf(hints)
      for (const type of missing) expect(said).toContain(category[categoryOf(type)!])
    })
  })
})
