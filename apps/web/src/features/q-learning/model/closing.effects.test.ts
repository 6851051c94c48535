import { addBlocks, knowMaps } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { cardProject } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { flushSync } from 'svelte'
import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { loadCard } from '#content/cards.ts'
import { assetsFromDisk } from '#lab/testing/assets.ts'
import { closeSessions, screen, sessionOf } from '#lab/testing/session.ts'
import type { LabUi } from '#lab/ui.svelte.ts'
import { freshDevice } from '#storage/testing/device.ts'
import type { Blocks } from './block-edits.ts'
import { Learning } from './learning.svelte.ts'

// Taking the drawing of a map apart needs the document of a page; no picture is drawn here.
vi.mock('#figures/map/picture.ts', () => ({ takeApart: () => ({}) }))

addBlocks(learning)
knowMaps(content)

let draw: ReturnType<typeof screen>
beforeEach(async () => {
  vi.stubGlobal('document', Object.assign(new EventTarget(), { hidden: false, documentElement: {} }))
  vi.stubGlobal('window', globalThis)
  vi.stubGlobal('addEventListener', () => {})
  vi.stubGlobal('removeEventListener', () => {})
  await freshDevice()
  assetsFromDisk()
  draw = screen()
})
afterEach(() => {
  closeSessions()
  vi.unstubAllGlobals()
})

/** Draws a frame, and waits for the task that follows it. */
async function frame(): Promise<void> {
  draw()
  for (let turns = 0; turns < 3; turns += 1) await new Promise((done) => setTimeout(done))
  flushSync()
}

/** The railway whose learning has just ended in turbo: from the next frames on its way is laid on the floor. */
async function learned() {
  const card = (await loadCard('railway'))!
  const project = cardProject(card.world, card.card, content.program('railway', 'solution')!, 'railway')
  const { session, kinds } = sessionOf(project, { card })
  const start = vi.fn()
  const playground = new Learning(session, { start } as unknown as LabUi, {} as Blocks, 1)
  const close = playground.open()
  flushSync()
  for (let frames = 0; frames < 20 && playground.shown === null; frames += 1) await frame()
  playground.player.speed = Infinity
  const learn = () => {
    playground.again()
    playground.play()
    for (let frames = 0; frames < 200 && playground.state !== 'over'; frames += 1) draw()
    expect(playground.state).toBe('over')
  }
  learn()
  return { session, kinds, start, close, learn }
}

const lines = ({ session }: Awaited<ReturnType<typeof learned>>) => session.lab.document.world.lines.length

test('a learned way lies on the floor within four frames, and Bo drives it', async () => {
  const lab = await learned()
  expect(lines(lab)).toBe(0)
  for (let frames = 0; frames < 4; frames += 1) await frame()
  expect(lines(lab)).toBeGreaterThan(0)
  expect(lab.start).toHaveBeenCalledTimes(1)
  lab.close()
})

test.each([0, 1, 2])(
  'a playground that is closed after %i of the three frames before its way is laid writes nothing more',
  async (drawn) => {
    const lab = await learned()
    for (let frames = 0; frames < drawn; frames += 1) await frame()
    lab.close()
    const [before, { project }] = [lab.kinds(), lab.session]
    for (let frames = 0; frames < 6; frames += 1) await frame()
    expect(lab.kinds()).toEqual(before)
    expect(lab.session.project).toEqual(project)
    expect(lines(lab)).toBe(0)
    expect(lab.start).not.toHaveBeenCalled()
  },
)

test('a playground that is closed while its laid way is drawn does not start Bo', async () => {
  const lab = await learned()
  for (let frames = 0; frames < 3; frames += 1) await frame()
  expect(lines(lab)).toBeGreaterThan(0)
  lab.close()
  const before = lab.kinds()
  await frame()
  expect(lab.kinds()).toEqual(before)
  expect(lab.start).not.toHaveBeenCalled()
})

test('a playground that is closed while its way already lies on the floor leaves Bo where the user put it', async () => {
  const lab = await learned()
  for (let frames = 0; frames < 4; frames += 1) await frame()
  const { session } = lab
  lab.learn()
  const { x, y, heading } = session.robot.pose
  const after = { x: x + 10, y, heading }
  session.apply({ kind: 'place', id: session.robotId, after })
  lab.close()
  for (let frames = 0; frames < 6; frames += 1) await frame()
  expect(session.robot.pose).toEqual(after)
})
