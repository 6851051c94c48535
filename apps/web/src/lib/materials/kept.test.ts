import { beforeEach, expect, test, vi } from 'vitest'
import { loadCard } from '#lib/content/cards.ts'
import { freshDevice, load, save } from '#lib/storage/projects-for-tests.ts'
import { noteHint, progressOf } from './kept.ts'

vi.mock('#lib/storage/projects.ts', () => import('#lib/storage/projects-for-tests.ts'))
beforeEach(() => freshDevice())

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
  await save('friendship', { ...project, programs: {}, progress: { starts: [0, 2], hints: 2 } }, revision)
  expect(await noteHint(card, 1)).toEqual({ starts: [0, 2], hints: 2 })
  expect((await load('friendship'))?.project.programs).toEqual({})
})

test('where nothing can be kept, a hint is seen all the same', async () => {
  freshDevice({ keepsNothing: true })
  expect(await noteHint(card, 3)).toEqual({ starts: [], hints: 3 })
  expect(await progressOf('friendship')).toEqual({ starts: [], hints: 0 })
})
