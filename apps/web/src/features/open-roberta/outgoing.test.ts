import { readFileSync } from 'node:fs'
import { content } from '@botgarten/content/files'
import { parseProject } from '@botgarten/programs'
import { projectFrom } from '@botgarten/programs/open-roberta'
import { expect, it } from 'vitest'
import { filesOf, outgoingOf } from './outgoing.ts'

const read = (path: string) => readFileSync(new URL(`../../../../../${path}`, import.meta.url), 'utf8')
const world = content.world('friendship')!
const solution = {
  ...content.program('friendship', 'solution')!,
  ...{ botgarten: 1 as const, assets: {}, world, name: 'Meins: A/B' },
}
const foreign = projectFrom(
  read('packages/programs/testing/open-roberta/programs/upstream__xNN__action.xml'),
  'meins ab',
  world,
)

it('every program of every project has a file, under a name that is free', () => {
  const files = filesOf([solution, foreign, foreign], 'with steps')
  expect(Object.keys(files)).toEqual([
    'Meins AB.xml',
    'with steps/Meins AB.xml',
    'meins ab 2.xml',
    'meins ab 3.xml',
  ])
  expect(files['with steps/Meins AB.xml']).toContain('robActions_NNstep')
  expect(files['Meins AB.xml']).toContain('ai_neural_network')
})

it('robots with programs of their own have a file each, those that share one have one', () => {
  const [bo] = world.robots
  const robots = [bo!, { ...bo!, id: 'two', program: 'other' }, { ...bo!, id: 'three' }]
  const several = { ...foreign, programs: { ...foreign.programs, other: foreign.programs['main']! } }
  const project = parseProject(
    JSON.stringify({
      ...several,
      world: {
        ...world,
        robots: robots.map((one) => ({ ...one, program: one.id === 'two' ? 'other' : 'main' })),
      },
    }),
  )
  expect(Object.keys(filesOf([project], ''))).toEqual(['meins ab.xml', 'meins ab 2.xml'])
})

it('what Open Roberta knows all of is asked about no more', () => {
  expect(outgoingOf(foreign, '').kin).toEqual([])
  expect(outgoingOf(solution, '')).toMatchObject({ kin: ['network'], network: 'steps' })
})
