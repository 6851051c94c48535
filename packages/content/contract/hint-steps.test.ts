import { describe, expect, it } from 'vitest'
import { content } from '../files.ts'
import { hintDue } from '../hintDue.ts'

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
