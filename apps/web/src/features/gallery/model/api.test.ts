import { beforeEach, expect, test, vi } from 'vitest'
import type { Ask, Reply } from '#storage/ask.ts'
import { friendship } from '#storage/testing/sample.ts'
import { fetchShared, giveHeart, sendShared } from './api.ts'

const answers =
  (reply: Reply): Ask =>
  () =>
    Promise.resolve(reply)
const refuses = (code: string) => answers({ kind: 'refused', status: 409, code, facts: {} })
const shares = (ask: Ask) => sendShared(ask, 'share', friendship, 'Rally')

beforeEach(() => void vi.spyOn(console, 'warn').mockImplementation(() => {}))

test('a child hears whether its own shelf is full or the class, and that an unknown refusal may end', async () => {
  expect(await shares(refuses('galleryFull'))).toBe('full')
  expect(await shares(refuses('classFull'))).toBe('classFull')
  expect(await shares(refuses('pupilFull'))).toBe('pupilFull')
  expect(await shares(refuses('new in a later server'))).toBe('away')
  expect(await shares(answers({ kind: 'away' }))).toBe('away')
})

test('a pupil who gives too many hearts gets a sentence of its own', async () => {
  expect(await giveHeart(refuses('tooManyHearts'), 'one', true)).toBe('tooManyHearts')
})

test('a project is shared under its title, without the own progress', async () => {
  const sent: unknown[] = []
  const ask: Ask = (...request) => {
    sent.push(request)
    return Promise.resolve({ kind: 'done', body: { waiting: true } })
  }
  const own = { ...friendship, progress: { starts: [0], hints: 1 } }
  expect(await sendShared(ask, 'abc', own, 'Rally')).toEqual({ waiting: true })
  const [[method, path, text]] = sent as [[string, string, string]]
  expect([method, path]).toEqual(['POST', '/gallery?share=abc'])
  expect(JSON.parse(text)).toMatchObject({ name: 'Rally' })
  expect(JSON.parse(text)).not.toHaveProperty('progress')
})

test('a shared project that this page cannot read has another reason than one that is gone', async () => {
  const item = {
    ...{ id: 'one', title: 'Rally', card: null, at: 1, by: 'Eule', own: false, brain: true, photo: false },
    ...{
      hidden: false,
      waiting: false,
      hearts: 0,
      mine: false,
      from: null,
      world: friendship.world,
      chain: [],
    },
  }
  const opens = (project: unknown) =>
    fetchShared(answers({ kind: 'done', body: { ...item, project } }), 'one')
  expect(await opens(friendship)).toMatchObject({ title: 'Rally', project: { name: friendship.name } })
  expect(await opens({ ...friendship, programs: 'none' })).toBe('unread')
  expect(await fetchShared(refuses('noSuchShared'), 'one')).toBe('gone')
})
