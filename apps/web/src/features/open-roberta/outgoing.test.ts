import { readFileSync } from 'node:fs'
import { content } from '@botgarten/content/files'
import { parseProject } from '@botgarten/programs'
import { projectFrom } from '@botgarten/programs/open-roberta'
import { afterEach, expect, it, vi } from 'vitest'
import { filesOf, outgoingOf, save } from './outgoing.ts'

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

afterEach(() => {
  vi.unstubAllGlobals()
  vi.restoreAllMocks()
})

it('a name has eighty letters at the most, and is never empty', () => {
  const nameOf = (name: string) => Object.keys(filesOf([{ ...foreign, name }], ''))
  expect(nameOf('x'.repeat(81))).toEqual([`${'x'.repeat(80)}.xml`])
  expect(nameOf('?/')).toEqual(['botgarten.xml'])
})

it('a program is saved as it is, and only where that is wanted with its network in steps', async () => {
  const files: Blob[] = []
  const links: { download: string }[] = []
  vi.spyOn(URL, 'createObjectURL').mockImplementation((blob) => `blob:${files.push(blob as Blob)}`)
  vi.stubGlobal('document', {
    createElement: () => {
      const link = { click: () => {}, download: '' }
      links.push(link)
      return link
    },
  })
  save(outgoingOf(solution, world.robots[0]!.id))
  save(outgoingOf(solution, world.robots[0]!.id), true)
  const [whole, steps] = (await Promise.all(files.map((file) => file.text()))) as [string, string]
  expect([whole.includes('ai_neural_network'), whole.includes('robActions_NNstep')]).toEqual([true, false])
  expect([steps.includes('ai_neural_network'), steps.includes('robActions_NNstep')]).toEqual([false, true])
  expect(links.map(({ download }) => download)).toEqual(Array(2).fill('Meins AB.xml'))
  expect(files.map(({ type }) => type)).toEqual(Array(2).fill('application/xml'))
})

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
