import { addBlocks } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { cardProject } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { flushSync } from 'svelte'
import { afterEach, beforeAll, expect, test, vi } from 'vitest'
import { closeSessions, screen, sessionOf } from '#lab/testing/session.ts'
import { Senses } from './senses.svelte.ts'

// Whether motion is reduced is queried when the module loads.
vi.hoisted(() => {
  const matchMedia = () => Object.assign(new EventTarget(), { matches: false })
  vi.stubGlobal('window', Object.assign(new EventTarget(), { matchMedia }))
})

beforeAll(() => addBlocks(learning))
afterEach(() => {
  closeSessions()
  vi.unstubAllGlobals()
})

test('the curve of an earlier night goes when the robot begins to try from nothing', () => {
  const draw = screen()
  const { card } = content.card('try-dodge')!
  const { programs, brains } = content.program('try-dodge', 'solution')!
  const project = cardProject(content.world(card.world)!, card, { programs, brains }, 'Mine')
  const { session } = sessionOf(project, { isCard: false })
  const senses = new Senses(session, () => {})
  const close = senses.open()
  flushSync()
  senses.night.note([{ pay: 12, bumps: 3 }] as never)
  expect(senses.night.shown.curve).toHaveLength(1)
  session.lab.start()
  const stop = session.lab.run()
  for (let frame = 0; frame < 10; frame += 1) draw()
  stop()
  session.lab.pause()
  flushSync()
  expect(senses.now).toMatchObject({ stage: 'trying', curve: [] })
  expect(senses.night.shown.curve).toEqual([])
  close()
})
