import { parseProject } from '@botgarten/programs'
import { describe, expect, test } from 'vitest'
import { allCards, loadCard } from './cards.ts'
import { exampleCards, newProject } from './new-project.ts'

test('a new project is a start block, a robot and a floor', async () => {
  const project = await newProject('Mine', null)
  expect(parseProject(JSON.parse(JSON.stringify(project)) as unknown).name).toBe('Mine')
  const { stacks } = project.programs['main']!
  expect(stacks.flatMap(({ blocks }) => blocks.map(({ type }) => type))).toEqual(['robControls_start'])
  const { robots, obstacles, areas, lines } = project.world
  expect([robots.length, obstacles, areas, lines]).toEqual([1, [], [], []])
})

test('every bed offers an example', () => {
  expect(exampleCards.map(({ bed }) => bed)).toEqual([...new Set(allCards.map(({ bed }) => bed))])
})

describe.each(exampleCards.map(({ id }) => id))('the example %s', (id) => {
  test('begins as its card does, and belongs to no card', async () => {
    const project = await newProject('Mine', id)
    expect(parseProject(JSON.parse(JSON.stringify(project)) as unknown)).not.toHaveProperty('card')
    expect(project.programs).toEqual((await loadCard(id))!.start.programs)
    expect(project.name).toBe('Mine')
  })
})
