import { content } from '@botgarten/content/files'
import { cardProject } from '@botgarten/content/document'
import { createLab } from '@botgarten/lab'
import { paintFloor } from '@botgarten/simulation'
import { expect, it } from 'vitest'
import { addBlocks } from '@botgarten/blocks'
import { learning, learningToolbox } from '@botgarten/blocks/packs/learning'
import { afterLearning } from './learned.ts'

addBlocks(learning, learningToolbox)
const mapOf = (id: string) => Promise.resolve(id.startsWith('own:') ? null : content.mapFile(id))

function projectOf(id: string, program: 'start' | 'solution') {
  const { card, world } = content.card(id)!
  return cardProject(world, card, content.program(id, program)!, id)
}

it('what has learned a way by trying drives it', async () => {
  const learned = await afterLearning(projectOf('mars', 'solution'), mapOf)
  expect(learned!.world.lines.map(({ id }) => id)).toContain('goal')
  const lab = createLab()
  lab.load(learned!, paintFloor(learned!.world), { seed: 1, checks: [] })
  const { pose } = lab.view('').robots[0]!
  lab.start()
  lab.advance(300, 0)
  expect(lab.view('').robots[0]!.pose).not.toEqual(pose)
})

it('tables that were shared before they had a seed are read as learned, too', async () => {
  const { q: _q, ...project } = projectOf('mars', 'solution')
  for (const q of [undefined, {}])
    expect(
      (await afterLearning({ ...project, ...(q && { q }) }, mapOf))!.world.lines.map(({ id }) => id),
    ).toContain('goal')
})

it('where nothing is learned by trying there is nothing to drive so', async () => {
  expect(await afterLearning(projectOf('friendship', 'solution'), mapOf)).toBe(null)
})

it('a map that is not there is none', async () => {
  const project = projectOf('mars', 'solution')
  const text = JSON.stringify(project).replaceAll(/"MAP":"[^"]*"/g, '"MAP":"own:nowhere"')
  expect(await afterLearning(JSON.parse(text) as typeof project, mapOf)).toBe(null)
})
