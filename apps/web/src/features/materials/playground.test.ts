import { beforeEach, expect, test } from 'vitest'
import { database } from '#storage/database.ts'
import { load, save } from '#storage/projects.ts'
import { deviceThatKeepsNothing, freshDevice, keysIn } from '#storage/testing/device.ts'
import { language } from '#words/language.svelte.ts'
import { layOut } from './playground.ts'
import { programOf } from './programs.ts'

beforeEach(() => freshDevice())

async function keptKeys() {
  await database()
  return keysIn('projects')
}
const programsIn = async (id: string) => (await load(id))?.project.programs
const programsOf = async (file: string) => (await programOf('friendship', file)).program.programs

test('a solution is kept for its slide, beside what a child keeps of the card', async () => {
  expect(await layOut('friendship', 'solution')).toEqual({ id: 'slide-friendship-solution', asStart: false })
  expect(await keptKeys()).toEqual(['slide-friendship-solution'])
  expect(await programsIn('slide-friendship-solution')).toEqual(await programsOf('solution'))
})

test.each([
  ['de', 'Freundschaft · auf Folien'],
  ['en', 'Friendship · on slides'],
] as const)('in %s its name says that it is one of slides', async (locale, name) => {
  await language.speak(locale)
  const { id } = await layOut('friendship', 'solution')
  expect((await load(id))?.project.name).toBe(name)
})

test('nothing is kept for a start program that nobody has touched', async () => {
  expect(await layOut('friendship', 'start')).toEqual({ id: 'slide-friendship-start', asStart: false })
  expect(await keptKeys()).toEqual([])
})

test.each(['start', 'solution'])('what the last class did with the %s is taken back', async (file) => {
  const { id } = await layOut('friendship', 'solution')
  const touched = (await load(id))!.project
  const place = `slide-friendship-${file}`
  await save(
    place,
    { ...touched, programs: { main: { stacks: [], config: { stacks: [] } } } },
    (await load(place))?.revision ?? 0,
  )
  await layOut('friendship', file)
  expect(await programsIn(place)).toEqual(await programsOf(file))
})

test('where nothing can be kept, the card stands there with its start program, and that is told', async () => {
  await deviceThatKeepsNothing()
  expect((await layOut('friendship', 'solution')).asStart).toBe(true)
  expect((await layOut('friendship', 'start')).asStart).toBe(false)
})

test('two windows that lay out the same slide at once do not hinder each other', async () => {
  const both = await Promise.all([layOut('friendship', 'solution'), layOut('friendship', 'solution')])
  expect(both.map(({ asStart }) => asStart)).toEqual([false, false])
})
