import { expect, test } from 'vitest'
import type { Block } from '@botgarten/blocks'
import { content } from '../files.ts'
import { kindsOf, newBlocks, type ProgramsOfCard } from './newBlocks.ts'
import { there } from '../contract/there.ts'

const cards = content.cards.map(({ id }) => {
  const programs = { start: content.program(id, 'start')!, solution: content.program(id, 'solution')! }
  return [id, programs] as const
})
const shown = newBlocks(cards)

/** A block with what is in its sockets, whatever stands between its arms. */
const standing = ({ statements: _, values, ...block }: Block): unknown => ({
  ...block,
  ...(values && {
    values: Object.fromEntries(Object.entries(values).map(([name, value]) => [name, standing(value)])),
  }),
})
const kinds = (block: Block): readonly string[] => [
  block.type,
  ...Object.values(block.values ?? {}).flatMap(kinds),
]
const named = (programs: ProgramsOfCard, id: string) =>
  [programs.start, programs.solution].flatMap((program) => {
    const text: unknown[] = []
    JSON.stringify(program.programs, (_, value: unknown) => {
      if (typeof value === 'object' && value !== null && 'id' in value && value.id === id)
        text.push(standing(value as Block))
      return value
    })
    return text
  })

test.each(cards)('each block on the front of %s stands so in a program of the card', (card, programs) => {
  for (const block of shown[card]!) {
    expect(block).not.toHaveProperty('statements')
    expect(named(programs, block.id)).toContainEqual(standing(block))
  }
})

test('Chameleon shows the network as its program has it: a colour in, a lamp out', () => {
  expect(shown['chameleon']!.map(kinds)).toEqual([
    [
      'ai_neural_network',
      'ai_easy_list',
      'ai_nn_input_node_coloursensor_color',
      'ai_easy_list',
      'ai_nn_output_node_led',
    ],
  ])
  expect(shown['caution']).toEqual([])
  expect(shown['friendship']).toEqual([])
})

test('what the card leaves open is not given away: numbers are those of the program to begin with', () => {
  expect(shown['forward']!.map(({ values }) => values!['DISTANCE']!.fields)).toEqual([{ NUM: '50' }])
})

test('whoever has done the cards in order has met every block of a solution on a front', () => {
  const met = new Set<string>()
  for (const [card, { solution }] of cards) {
    for (const type of shown[card]!.flatMap(kinds)) met.add(type)
    const given = ['robControls_start', 'math_number', 'text', 'robColour_picker']
    expect(kindsOf(solution).filter((type) => !met.has(type) && !given.includes(type))).toEqual([])
  }
})

test('no block stands on two fronts, and each is one that there is', () => {
  const all = Object.values(shown).flatMap((blocks) => blocks.map(({ type }) => type))
  expect(new Set(all).size).toBe(all.length)
  const { blocks } = there()
  expect(all.filter((type) => !blocks.has(type))).toEqual([])
})
