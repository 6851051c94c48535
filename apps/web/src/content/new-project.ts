import { cardProject } from '@botgarten/content/document'
import type { Project } from '@botgarten/programs'
import { allCards, loadCard, loadFreeLab } from './cards.ts'

/** Cards whose beginnings are offered as examples: the first of each bed. */
export const exampleCards = allCards.filter((card) => allCards.find(({ bed }) => bed === card.bed) === card)

/** A project that belongs to no card. `example`: the card whose blocks and world it begins with, or null for an empty one. */
export async function newProject(name: string, example: string | null): Promise<Project> {
  const found = example === null ? null : await loadCard(example)
  if (!found) return emptyProject(name)
  const { card: _card, ...project } = cardProject(found.world, found.card, found.start, name)
  return project
}

/** A project of the sorting playground, which is called like it. */
export async function sortingProject(sorting?: Project['sorting']): Promise<Project> {
  const empty = await emptyProject('sorting')
  return { ...empty, botgarten: 5, playground: 'sorting', ...(sorting && { sorting }) }
}

/** A start block, a robot and a floor. */
async function emptyProject(name: string): Promise<Project> {
  const { programs, world, ...free } = await loadFreeLab()
  const onlyFirst = Object.entries(programs).map(([id, program]) => {
    const stacks = program.stacks.slice(0, 1).map((stack) => ({ ...stack, blocks: stack.blocks.slice(0, 1) }))
    return [id, { ...program, stacks }] as const
  })
  return {
    ...free,
    name,
    programs: Object.fromEntries(onlyFirst),
    world: { ...world, floor: { colour: '#FFFFFF' }, areas: [], lines: [], obstacles: [] },
  }
}
