import 'fake-indexeddb/auto'
import { readFileSync } from 'node:fs'
import { addBlocks } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { cardProject } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import type { Project } from '@botgarten/programs'
import { afterEach, beforeAll, beforeEach, expect, test, vi } from 'vitest'
import { stageOf } from '#figures/map/testing/stage.ts'
import { closeSessions, sessionOf } from '#lab/testing/session.ts'
import { freshLocalStorage } from '#storage/testing/local.ts'
import { fetchWords } from '#words/message.ts'
import { Code } from './code.svelte.ts'
import { learnedIn } from './learned.ts'

// Only a browser can draw the picture of a map.
vi.mock('#figures/map/stage.ts', () => ({
  loadStage: (id: string) =>
    Promise.resolve(stageOf(id, readFileSync(content.path('maps', id, 'map.svg'), 'utf8'))),
}))
beforeAll(async () => {
  addBlocks(learning)
  await fetchWords('python', 'expert')
})
beforeEach(() => void freshLocalStorage())
afterEach(() => {
  closeSessions()
  vi.unstubAllGlobals()
})

function solved(card: string): Project {
  const loaded = content.card(card)!
  return cardProject(loaded.world, loaded.card, content.program(card, 'solution')!, card)
}
const codeOf = (card: string) =>
  new Code(sessionOf(solved(card), { isCard: false }).session, () => 'My robot')

test('what was learned by trying is in the file once the map is there, and can then go on being learned', async () => {
  const code = codeOf('railway')
  const before = code.file.text
  expect(code.canLearn).toBe(false)
  await code.learn()
  expect(code.canLearn).toBe(true)
  expect(code.file.text).not.toBe(before)
})

test('a program that learns nothing on a map has learned nothing', async () => {
  expect(await learnedIn(solved('friendship').programs['main']!, undefined)).toEqual({})
})
