import { cardProject } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { writeProject } from '@botgarten/programs/project'
import { beforeEach, expect, test, vi } from 'vitest'
import { titleOf } from '#content/names.ts'
import { assetsFromDisk } from '#lab/testing/assets.ts'
import type { Ask, Reply } from '#storage/ask.ts'
import { nameOfCopy } from '#storage/messages.ts'
import { list, save } from '#storage/projects.ts'
import { fillDisk, freshDevice } from '#storage/testing/device.ts'
import { takeOffer } from './offer.ts'
import type { Handout } from './pupil.ts'

beforeEach(async () => {
  await freshDevice()
  assetsFromDisk()
})

const { card, world } = content.card('friendship')!
const project = {
  ...cardProject(world, card, content.program('friendship', 'start')!, 'friendship'),
  name: 'Two eyes',
}
const handout: Handout = { id: 'h1', kind: 'program', card: null, hint: null, text: 'Two eyes' }

/** A class whose handout `h1` has this answer. */
const classWith =
  (reply: Reply): Ask =>
  (method, path) =>
    Promise.resolve(method === 'GET' && path === '/me/handouts/h1' ? reply : { kind: 'away' })
const sends = (project: unknown) => classWith({ kind: 'done', body: { project } })
const sent = sends(JSON.parse(writeProject(project)) as unknown)
const namesHere = async () => (await list()).projects.map(({ project }) => project.name).toSorted()

test('a project of the teacher gets a place of its own, and the own work stays as it is', async () => {
  await save('friendship', { ...project, name: '' }, 0)
  const taken = await takeOffer(sent, handout)
  expect(taken).toMatchObject({ card: 'friendship', id: expect.stringMatching(/^friendship-./) as string })
  expect(await namesHere()).toEqual(['', 'Two eyes'])
})

test('where its name is taken already it is called a copy', async () => {
  await takeOffer(sent, handout)
  await takeOffer(sent, handout)
  expect(await namesHere()).toEqual(['Two eyes', nameOfCopy('Two eyes', [])])
})

test('the start program of a card never has the name of the own work on that card', async () => {
  expect(await takeOffer(sends(null), { ...handout, card: 'friendship' })).toMatchObject({
    card: 'friendship',
  })
  expect(await namesHere()).toEqual([nameOfCopy(titleOf('friendship'), [])])
})

test.each([
  ['a class that does not answer', classWith({ kind: 'away' }), handout],
  ['an answer that is no project', sends({ version: 1 }), handout],
  ['an unknown card', sends(null), { ...handout, card: 'no-such-card' }],
  ['neither a project nor a card', sends(null), handout],
])('nothing is taken from %s', async (_, ask, offered) => {
  vi.spyOn(console, 'warn').mockImplementation(() => {})
  expect(await takeOffer(ask, offered)).toBe('away')
  expect(await namesHere()).toEqual([])
})

test('a full disk is no success', async () => {
  const empty = fillDisk()
  expect(await takeOffer(sent, handout)).toBe('notKept')
  empty()
  expect(await namesHere()).toEqual([])
})
