import 'fake-indexeddb/auto'
import { addBlocks } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { content } from '@botgarten/content/files'
import { playedFrom, type Project } from '@botgarten/programs'
import { afterAll, beforeAll, beforeEach, expect, test } from 'vitest'
import { load, save } from '#storage/projects.ts'
import { fillDisk, freshDevice } from '#storage/testing/device.ts'
import { friendship as painted } from '#storage/testing/sample.ts'
import { language } from '#words/language.svelte.ts'
import { beginCard, cardsHere, keepCard, openDraft } from './cards.ts'

const friendship: Project = { ...painted, world: { ...painted.world, floor: { colour: '#FFFFFF' } } }
const packs = { loadFor: () => Promise.resolve(false), loadLearning: () => Promise.resolve() }

beforeAll(() => addBlocks(learning))
beforeEach(freshDevice)
afterAll(() => language.speak('en'))

test('a card is made of a project, which stays as it is, and opens as a draft', async () => {
  await save('mine', friendship, 0)
  const id = (await beginCard(friendship, 'Meet', content.card('friendship')!.card))!
  expect((await load('mine'))!.project).toEqual(friendship)
  const draft = (await openDraft(id, packs))!
  expect(draft).toMatchObject({ id, project: { name: 'Meet', ownCard: { draft: true } } })
  expect(draft.project.ownCard.text).toMatchObject({ en: { title: 'Meet' } })
  expect((await cardsHere()).map((one) => one.id)).toEqual([id])
})

test('its words begin in German where that is spoken', async () => {
  await language.speak('de')
  const id = (await beginCard(friendship, 'Treffen'))!
  expect((await load(id))!.project.ownCard!.text).toMatchObject({ de: { title: 'Treffen' } })
  await language.speak('en')
})

test('only a draft opens: no project without a card, no finished card, nothing that is not there', async () => {
  await save('mine', friendship, 0)
  const id = (await beginCard(friendship, 'Meet', content.card('friendship')!.card))!
  const { ownCard, ...project } = (await load(id))!.project
  const words = { title: 'Meet', story: 'S', task: 'T', hints: ['1', '2', '3'] as const }
  const whole = { ...ownCard!, text: { en: words } }
  const finished = (await keepCard(playedFrom({ ...project, ownCard: whole }, false)))!
  expect([
    await openDraft('mine', packs),
    await openDraft(finished, packs),
    await openDraft('x', packs),
  ]).toEqual([...[null, null, null]])
  expect((await cardsHere()).map((one) => one.id).sort()).toEqual([id, finished].sort())
})

test('where the device has no room no card begins, and none is added', async () => {
  const makeRoom = fillDisk()
  expect([await beginCard(friendship, 'Meet'), await keepCard(friendship)]).toEqual([null, null])
  makeRoom()
})
