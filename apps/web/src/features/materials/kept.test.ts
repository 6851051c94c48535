import { beforeEach, expect, test } from 'vitest'
import { loadCard } from '#content/cards.ts'
import { load, save } from '#storage/projects.ts'
import { deviceThatKeepsNothing, freshDevice, recordIn } from '#storage/testing/device.ts'
import { noteHint, progressOf } from './kept.ts'

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
