import type { Block } from '@botgarten/blocks'
import type { Brain } from '@botgarten/learning/neural-network'
import { describe, expect, it } from 'vitest'
import { content } from '../files.ts'
import { hintDue } from '../hintDue.ts'
import type { CardProgram } from '../index.ts'

const cards = content.cards
  .map(({ id }) => ({ id, ...content.card(id)!, solution: content.program(id, 'solution')! }))
  .filter(({ card }) => card.hintSteps)

describe.each(cards)('the hints of $id', ({ card, text, start, solution }) => {
  const steps = card.hintSteps!

  it('begin with the first on the untouched card', () => {
    expect(hintDue(steps, start)).toBe(0)
  })

  it('are all followed in the solution, up to the last one that the program shows', () => {
    expect(hintDue(steps, solution)).toBe(steps.length)
  })

  it('leave one hint at least without a step: the last one tells the solution', () => {
    for (const { hints } of Object.values(text)) expect(steps.length).toBeLessThan(hints.length)
  })

  it('each name a measure that changes between start and solution', () => {
    for (const step of steps)
      if (step) {
        expect(hintDue([step], start)).toBe(0)
        expect(hintDue([step], solution)).toBe(1)
      }
  })
})

it('a step that no program shows counts as followed once a later one is', () => {
  const { card, start } = content.card('chameleon')!
  const green = content.program('chameleon', 'wrong/only-green')!
  const solution = content.program('chameleon', 'solution')!
  expect(hintDue([null, card.hintSteps![1]!], start)).toBe(0)
  expect(hintDue([null, card.hintSteps![1]!], solution)).toBe(2)
  expect(hintDue(card.hintSteps, green)).toBe(1)
  expect(hintDue([{ ai_nn_input_node: 3 }, { knobs: 1 }], green)).toBe(0)
})

describe('a step is not followed', () => {
  const changed = (id: string, change: (program: CardProgram) => void) => {
    const program = structuredClone(content.program(id, 'solution')!)
    change(program)
    return hintDue(content.card(id)!.card.hintSteps, program)
  }

  it('by a block that lies beside the program', () => {
    const due = changed('loud-distance', ({ programs }) => {
      const stacks = programs['main']!.stacks as unknown as { x: number; y: number; blocks: Block[] }[]
      const rest = stacks[0]!.blocks.splice(1)
      stacks.push({ x: 0, y: 0, blocks: rest })
    })
    expect(due).toBe(0)
  })

  it('by the knobs of a network that was deleted', () => {
    const due = changed('friendship', ({ brains }) => {
      const all = brains as Record<string, Brain>
      all['gone'] = all['net']!
      all['net'] = { ...all['net']!, weights: {} }
    })
    expect(due).toBe(0)
  })

  it('by another road that is closed', () => {
    const other = structuredClone(content.card('railway')!.start)
    const text = JSON.stringify(content.program('railway', 'solution')).replaceAll('"FROM":"3"', '"FROM":"5"')
    expect(hintDue(content.card('railway')!.card.hintSteps, other)).toBe(0)
    expect(hintDue(content.card('railway')!.card.hintSteps, JSON.parse(text) as CardProgram)).toBe(0)
  })
})
