import type { Brain } from '@botgarten/learning/neural-network'
import { cardProject, type Card, type CardProgram } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { expect } from '@playwright/test'
import { NetHands } from './child-network.ts'
import { isTried, pays } from './child-paying.ts'
import { isPractised, practises } from './child-practising.ts'
import type { Child } from './child.ts'

/** A card with the programs it begins and ends with. */
export interface Task {
  readonly card: Card
  readonly start: CardProgram
  readonly solution: CardProgram
}

/** All cards of the product, in the order of their folders. */
export const tasks: readonly Task[] = content.cards.map(({ id }) => {
  const { card, start } = content.card(id)!
  return { card, start, solution: content.program(id, 'solution')! }
})

/**
 * Solves a card: numbers are typed into its blocks, knobs are set, examples are practised, or pay is chosen; where other blocks
 * are needed, they come from a file.
 */
export async function solves(child: Child, task: Task) {
  if (isPractised(task)) return practises(child, task)
  if (isTried(task)) return pays(child, task)
  const { card, start, solution } = task
  const numbers = numbersToType(start, solution)
  if (numbers) for (const [block, number] of numbers) await child.typesNumber(block, number)
  else {
    const world = content.world(card.world)!
    const program = { ...solution, brains: mapped(solution.brains, withoutWeights) }
    await child.opensProject('Mine', JSON.stringify(cardProject(world, card, program, 'Mine')))
  }
  if (card.playground === 'network') await setsKnobs(child, Object.values(solution.brains)[0]!)
}

/** Numbers that make the solution of the start, by block; null where it takes other blocks. */
function numbersToType(start: CardProgram, solution: CardProgram): Map<string, string> | null {
  const numbersOf = (program: CardProgram) => {
    const found = new Map<string, string>()
    const rest = JSON.stringify(program.programs, (_, value: unknown) => {
      if (!isNumberBlock(value)) return value
      found.set(value.id, value.fields.NUM)
      return value.id
    })
    return { found, rest }
  }
  const [before, after] = [numbersOf(start), numbersOf(solution)]
  if (before.rest !== after.rest) return null
  return new Map([...after.found].filter(([id, number]) => before.found.get(id) !== number))
}

const isNumberBlock = (value: unknown): value is { id: string; fields: { NUM: string } } =>
  typeof value === 'object' && value !== null && 'type' in value && value.type === 'math_number'

const mapped = <From, To>(all: { readonly [key: string]: From }, change: (one: From) => To) =>
  Object.fromEntries(Object.entries(all).map(([key, one]) => [key, change(one)]))

const withoutWeights = (brain: Brain): Brain => ({ ...brain, weights: {} })

/** Types every weight of a brain into its knob. Knobs come layer by layer, in the order of the blocks. */
async function setsKnobs(child: Child, { layers, weights }: Brain) {
  if (layers.length > 2) await new NetHands(child).chooses('explorer')
  const links = layers
    .slice(1)
    .flatMap((layer, before) =>
      layers[before]!.flatMap(({ id }) => layer.map((to) => weights[id]?.[to.id] ?? 0)),
    )
  await expect(child.knobs).toHaveCount(links.length)
  for (const [index, weight] of links.entries()) {
    const knob = child.knobs.nth(index)
    if ((await knob.getAttribute('aria-valuenow')) !== String(weight)) {
      await knob.focus()
      await child.types(...weight.toLocaleString(child.language), 'Enter')
    }
    await expect(knob).toHaveAttribute('aria-valuenow', String(weight))
  }
}
