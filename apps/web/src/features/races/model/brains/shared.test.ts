import 'fake-indexeddb/auto'
import { addBlocks } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { cardProject } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import type { Project } from '@botgarten/programs'
import { beforeAll, expect, test } from 'vitest'
import type { Ask, Reply } from '#storage/ask.ts'
import { freshDevice } from '#storage/testing/device.ts'
import { BrainRace } from './brain-race.svelte.ts'
import { openCourse } from './ground.ts'
import { sharedIn } from './shared.ts'

addBlocks(learning)
beforeAll(freshDevice)

function solved(card: string): Project {
  const loaded = content.card(card)!
  return cardProject(loaded.world, loaded.card, content.program(card, 'solution')!, card)
}

/** A class whose pupil has shared these, as the server answers its teacher. */
function classWith(shared: { readonly [title: string]: unknown }) {
  const asked: string[] = []
  const items = Object.keys(shared).map((title, at) => ({
    ...{ id: `shared-${at}`, title, card: null, at, by: 'Eule', own: false, brain: true, photo: false },
    ...{ hidden: false, waiting: false, hearts: 0, mine: false, world: {}, from: null },
  }))
  const answerTo = (path: string): object => {
    if (path.includes('?')) return { total: items.length, items }
    const one = items.find(({ id }) => path.endsWith(`/${id}`))!
    return { ...one, chain: [], project: shared[one.title] }
  }
  const ask: Ask = (method, path) => {
    asked.push(`${method} ${path}`)
    return Promise.resolve<Reply>({ kind: 'done', body: answerTo(path) })
  }
  return { ask, asked }
}

test('what a class has shared is fetched best liked first; what learns on a map or cannot be read is left out', async () => {
  const { ask, asked } = classWith({
    Shy: solved('friendship'),
    Train: solved('railway'),
    Broken: { botgarten: 1 },
  })
  const shared = await sharedIn('5 b', ask)
  expect(shared!.map(({ title, by }) => [title, by])).toEqual([['Shy', 'Eule']])
  expect(asked[0]).toBe('GET /classes/5%20b/gallery?by=hearts')
  expect(asked).toHaveLength(4)
})

test('brains of a class stand in the lanes of their kinds, the best liked of each, with who shared them', async () => {
  const { ask } = classWith({
    Rules: solved('four-brains'),
    Coins: solved('try-dodge'),
    Knobs: solved('friendship'),
    More: solved('fear'),
    Shown: solved('show-it'),
  })
  const course = (await openCourse('garden', null, '5b', ask))!
  expect(course.school).toEqual({ id: '5b', shared: 5 })
  expect(course.own.hand.map(({ name, by }) => [name, by])).toEqual([
    ['Knobs', 'Eule'],
    ['More', 'Eule'],
  ])
  const { chosen } = new BrainRace(course)
  expect(chosen).toEqual({ hand: 'shared-2', examples: 'shared-4', trying: 'shared-1', ifThen: 'shared-0' })
})

test('where the class cannot be reached or has shared nothing, the brains of the course drive', async () => {
  const away: Ask = () => Promise.resolve({ kind: 'away' })
  const course = (await openCourse('garden', null, '5b', away))!
  expect(course.school).toEqual({ id: '5b', shared: null })
  expect(new BrainRace(course).chosen.hand).toBe('')
  const empty = (await openCourse('garden', null, '5b', classWith({}).ask))!
  expect(empty.school).toEqual({ id: '5b', shared: 0 })
  expect((await openCourse('garden'))!.school).toBeNull()
})
