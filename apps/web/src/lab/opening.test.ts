import { content } from '@botgarten/content/files'
import { draftOf } from '@botgarten/content/own-card'
import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import * as packs from '#features/editor/model/packs.ts'
import { load, save } from '#storage/projects.ts'
import { deviceThatKeepsNothing, freshDevice, recordIn } from '#storage/testing/device.ts'
import { friendship, withPicture } from '#storage/testing/sample.ts'
import { openLab, ownPictureIn } from './opening.ts'

beforeEach(async () => {
  await freshDevice()
  vi.spyOn(console, 'warn').mockImplementation(() => {})
  vi.stubGlobal('fetch', () => Promise.reject(new TypeError('No network in a test.')))
})
afterEach(() => vi.unstubAllGlobals())

test('a card opens fresh where nothing is kept, and says whether anything can be', async () => {
  const opened = await openLab('friendship', null, packs)
  expect(opened).toMatchObject({ id: 'friendship', revision: 0, keeps: true, damaged: null, expert: false })
  expect(opened!.project).toMatchObject({ card: 'friendship', world: friendship.world })
  expect(opened!.card!.card.id).toBe('friendship')
  await deviceThatKeepsNothing()
  expect((await openLab('friendship', null, packs))!.keeps).toBe(false)
  expect(await openLab('no-such-card', null, packs)).toBeNull()
})

test('the floor whose picture does not come is white, and that is said', async () => {
  expect(await openLab('friendship', null, packs)).toMatchObject({ error: 'floorMissing' })
  const coloured = { ...friendship, world: { ...friendship.world, floor: { colour: '#00FF00' } } }
  await save('friendship', coloured, 0)
  expect(await openLab('friendship', null, packs)).toMatchObject({ error: null, floorAddress: null })
})

test('what is kept is opened, under the card or under a key of its own', async () => {
  await save('friendship', { ...friendship, name: 'mine' }, 0)
  await save('friendship-2', { ...friendship, name: 'second' }, 0)
  const { revision } = (await load('friendship'))!
  expect(await openLab('friendship', null, packs)).toMatchObject({
    project: { name: 'mine' },
    revision,
    keeps: true,
  })
  const second = await openLab('friendship', 'friendship-2', packs)
  expect(second).toMatchObject({ id: 'friendship-2', project: { name: 'second' } })
  expect((await openLab('free', 'friendship-2', packs))!.card).toBeNull()
})

test('the free lab shows the card that a project is made as, with its goals in words, but no draft of one', async () => {
  const { card } = content.card('friendship')!
  const begun = draftOf(friendship, 'Meet', 'en', card)
  const text = { title: 'Meet', story: 'A story.', task: 'Bo comes near.', hints: ['1', '2', '3'] as const }
  const { draft: _, ...ownCard } = { ...begun.ownCard!, text: { en: text } }
  await save('made', { ...begun, ownCard }, 0)
  const made = (await openLab('free', 'made', packs))!
  expect(made.card!.card.checks).toEqual(ownCard.checks)
  expect(Object.keys(made.card!.text.en!.checks)).toEqual(ownCard.checks.map(({ id }) => id))
  await save('draft', { ...begun, ownCard: { ...ownCard, draft: true } }, 0)
  expect((await openLab('free', 'draft', packs))!.card).toBeNull()
})

test('what is damaged stays where it is; what of it can be opened is a project of its own', async () => {
  await save('friendship', friendship, 0)
  const record = (await recordIn('projects', 'friendship')) as { project: object }
  const project = { ...record.project, name: 'n'.repeat(20_001) }
  await recordIn('projects', 'friendship', { ...record, project })
  const opened = await openLab('friendship', null, packs)
  expect(opened).toMatchObject({ revision: 0, error: 'partlyHere' })
  expect(opened!.id).toMatch(/^friendship-\w+/)
  expect(opened!.project.name).toHaveLength(20_000)
  expect(opened!.damaged).toMatchObject({ raw: project })
  await recordIn('projects', 'friendship', { ...record, project: 'scribble' })
  expect(await openLab('friendship', null, packs)).toMatchObject({
    ...{ error: 'brokenHere', project: { card: 'friendship' } },
    damaged: { name: 'friendship', raw: 'scribble' },
  })
  expect(((await recordIn('projects', 'friendship')) as { project: unknown }).project).toBe('scribble')
})

test('of all pictures only the one that the floor lies on is kept', () => {
  const { world, assets } = withPicture(4)
  expect(ownPictureIn(world.floor, { ...assets, other: assets[Object.keys(assets)[0]!]! })).toEqual(assets)
  expect(ownPictureIn(world.floor, {})).toEqual({})
  expect(ownPictureIn({ colour: '#FFFFFF' }, assets)).toEqual({})
})
