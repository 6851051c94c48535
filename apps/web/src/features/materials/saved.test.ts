import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { loadCard } from '#content/cards.ts'
import { load, save } from '#storage/projects.ts'
import { deviceThatKeepsNothing, freshDevice, recordIn, keysIn } from '#storage/testing/device.ts'
import { noteHint, progressOf, layOut, keepAnswers, readAnswers } from './saved.ts'
import { database } from '#storage/database.ts'
import { language } from '#words/language.svelte.ts'
import { programOf } from './programs.ts'

beforeEach(() => freshDevice())

const nothing = { stacks: [], config: { stacks: [] } }
const card = (await loadCard('friendship'))!

test('a card that nobody has opened is at its beginning', async () => {
  expect(await progressOf('friendship')).toEqual({ starts: [], hints: 0 })
})

test('a hint is noted in the project that the lab opens for the card', async () => {
  await noteHint(card, 1)
  expect(await progressOf('friendship')).toEqual({ starts: [], hints: 1 })
  expect((await load('friendship'))?.project.programs).toEqual(card.start.programs)
})

test('hints that were seen stay seen, and what a child has built and solved stays too', async () => {
  await noteHint(card, 2)
  const { project, revision } = (await load('friendship'))!
  await save(
    'friendship',
    { ...project, programs: { main: nothing }, progress: { starts: [0, 2], hints: 2 } },
    revision,
  )
  expect(await noteHint(card, 1)).toEqual({ starts: [0, 2], hints: 2 })
  expect((await load('friendship'))?.project.programs).toEqual({ main: nothing })
})

test('where nothing can be kept, a hint is seen all the same', async () => {
  await deviceThatKeepsNothing()
  expect(await noteHint(card, 3)).toEqual({ starts: [], hints: 3 })
  expect(await progressOf('friendship')).toEqual({ starts: [], hints: 0 })
})

test('a project that is damaged stays as it is, and the hint is seen', async () => {
  await noteHint(card, 1)
  const damaged = { id: 'friendship', project: { botgarten: 1 }, changed: 1, pictures: [] }
  await recordIn('projects', 'friendship', damaged)
  expect(await progressOf('friendship')).toEqual({ starts: [], hints: 0 })
  expect(await noteHint(card, 2)).toEqual({ starts: [], hints: 2 })
  expect(await recordIn('projects', 'friendship')).toEqual(damaged)
})

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
  await save(place, { ...touched, programs: { main: nothing } }, (await load(place))?.revision ?? 0)
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

const kept = new Map<string, string>()
vi.stubGlobal('localStorage', {
  getItem: (key: string) => kept.get(key) ?? null,
  setItem: (key: string, value: string) => kept.set(key, value),
})
afterEach(() => kept.clear())

test('what is answered is kept by module, before and after apart', () => {
  keepAnswers(2, 'before', { 'all-zero': 'stands' })
  expect(readAnswers(2, 'before')).toEqual({ 'all-zero': 'stands' })
  expect([readAnswers(2, 'after'), readAnswers(3, 'before')]).toEqual([{}, {}])
})

test.each(['not json', '"words"', 'null', '{"all-zero":5}', '[1]'])('%s is no answer', (text) => {
  kept.set('botgarten.questions-1-before', text)
  expect(readAnswers(1, 'before')).toEqual({})
})
