import { addBlocks, knowMaps, mapField } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { cardProject } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { drawWay } from '@botgarten/maps'
import type { Learned, LearnedRun } from '@botgarten/programs'
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest'
import type { LoadedCard } from '#content/cards.ts'
import type { Stage } from '#figures/map/stage.ts'
import { closeSessions, screen, sessionOf } from '#lab/testing/session.ts'
import type { LabUi } from '#lab/ui.svelte.ts'
import { freshDevice } from '#storage/testing/device.ts'
import type { Blocks } from './block-edits.ts'
import { Learning } from './learning.svelte.ts'
import { MOVE } from './time.ts'

addBlocks(learning)
knowMaps(content)
let draw: ReturnType<typeof screen>
beforeEach(async () => {
  await freshDevice()
  draw = screen()
  vi.stubGlobal('window', globalThis)
})
afterEach(() => {
  closeSessions()
  vi.unstubAllGlobals()
})

const { card, world } = content.card('railway')!
const railway = cardProject(world, card, content.program('railway', 'solution')!, 'railway')
const start = content.program('railway', 'start')!
/** The railway without its picture, which needs a document. */
const stage = { id: 'railway', map: content.mapFile('railway')!, roads: [] } as unknown as Stage

/** The playground of the railway; `program` is what a child made of it. */
function opened({
  pinned = null as number | null,
  learned = undefined as Learned | undefined,
  map = 'railway',
} = {}) {
  const text = JSON.stringify(railway).replace(mapField('railway'), mapField(map))
  const { session } = sessionOf(JSON.parse(text) as typeof railway, {
    card: { card, start } as unknown as LoadedCard,
  })
  if (learned) session.apply({ kind: 'learned', program: session.robot.program, after: learned })
  const ui = { start: () => {} } as unknown as LabUi
  const playground = new Learning(session, ui, {} as Blocks, pinned)
  vi.spyOn(playground.task, 'stage', 'get').mockReturnValue(stage)
  return { session, playground }
}
/** With its course at the beginning. */
function ready() {
  const { session, playground } = opened({ pinned: 1 })
  playground.again()
  const made = () => playground.screen.drawn!.made
  return { session, playground, made }
}

describe('a playground that is opened again', () => {
  const run = { seed: 4, way: '3-2-1' } as LearnedRun
  const learned = { seed: 4, moves: 7, key: 'k', noted: false, runs: [run, run] }

  test('has the runs of the project and its dice; the dice of a link go before', () => {
    const { playground } = opened({ learned })
    expect([playground.records.runs, playground.seed]).toEqual([[run, run], 4])
    expect(opened({ learned, pinned: 9 }).playground.seed).toBe(9)
    expect(opened({ pinned: 9 }).playground.records.runs).toEqual([])
  })

  test('keeps the runs when it saves, until they are deleted', () => {
    const { session, playground } = opened({ learned })
    playground.again()
    expect(session.learned).toMatchObject({ seed: 4, moves: 0, runs: [run, run] })
    playground.forgetRuns()
    expect(session.learned!.runs).toEqual([])
  })
})

describe('the map of the task', () => {
  test('is that of the card, or another one with its start and goal', () => {
    expect(opened().playground.task.elsewhere).toBeNull()
    const { elsewhere } = opened({ map: 'forest' }).playground.task
    expect(elsewhere).toMatchObject({ start: 3, goal: 1 })
  })
})

test('back to the start leaves Bo on a drawn way until the map is learned again', () => {
  const { session, playground } = ready()
  const { scene } = drawWay(stage.map, [3, 2, 1])
  session.apply({ kind: 'scene', after: scene })
  playground.drive.showMap({ ...stage, picture: { pale: '' } } as Stage)
  const placed = { x: scene.starts[0]!.x + 10, y: scene.starts[0]!.y, heading: 90 }
  session.apply({ kind: 'place', id: session.robotId, after: placed })
  session.toStart()
  expect(session.lab.view.robots[0]!.pose).toEqual(placed)
  expect(playground.drive.starts).toBeNull()
})

describe('playing', () => {
  test('makes a move a second at ×1, three at ×3, and saves on pause how far it came', () => {
    const { session, playground, made } = ready()
    expect([playground.state, made()]).toEqual(['ready', 0])
    playground.play()
    draw(0)
    const play = (frames: number) => {
      const before = made()
      for (let frame = 0; frame < frames; frame += 1) draw(MOVE / 10)
      return made() - before
    }
    play(1)
    expect(play(30)).toBeGreaterThanOrEqual(3)
    playground.player.speed = 3
    expect(play(20)).toBeGreaterThanOrEqual(6)
    expect(made()).toBeLessThanOrEqual(12)
    playground.pause()
    expect([playground.state, playground.progress]).toEqual(['paused', 1])
    expect(session.learned!.moves).toBe(made())
    expect(play(10)).toBe(0)
  })

  test('ends a ride that is shown', () => {
    const { playground } = ready()
    playground.play()
    draw(0)
    draw(MOVE)
    playground.pause()
    playground.walk()
    expect(playground.watch.on).toBe(true)
    playground.play()
    expect(playground.watch.on).toBe(false)
  })

  test('that is asked for again goes on as it is, and a pause of what does not play changes nothing', () => {
    const { playground, made } = ready()
    playground.pause()
    expect(playground.state).toBe('ready')
    playground.play()
    const frames = vi.spyOn(playground.player, 'start')
    playground.play()
    expect(frames).not.toHaveBeenCalled()
    playground.stop()
    const { seed } = playground
    playground.pause()
    expect([playground.state, made(), playground.seed]).toEqual(['stopped', made(), seed])
  })

  test.each([1, Infinity])('one move is one move at the speed ×%s', (speed) => {
    const { playground, made } = ready()
    playground.player.speed = speed
    for (const moves of [1, 2]) {
      playground.step()
      expect(playground.state).toBe('playing')
      for (let frame = 0; frame < 15; frame += 1) draw(MOVE / 10)
      expect([playground.state, made()]).toEqual(['paused', moves])
    }
  })

  test('a move that is asked for while it plays is the last one', () => {
    const { playground, made } = ready()
    playground.play()
    draw(0)
    for (let frame = 0; frame < 5; frame += 1) draw(MOVE / 10)
    const before = made()
    playground.step()
    for (let frame = 0; frame < 40; frame += 1) draw(MOVE / 10)
    expect(playground.state).toBe('paused')
    expect(made()).toBe(before)
  })

  test('in turbo goes to the end of all tries, which is a row of the table, once', () => {
    const { session, playground } = ready()
    playground.player.speed = Infinity
    playground.play()
    for (let frame = 0; frame < 100 && !playground.ended; frame += 1) draw(16)
    expect(playground.state).toBe('over')
    expect(playground.records.runs).toHaveLength(1)
    expect(playground.records.runs[0]!.episodes).toBe(playground.outline!.episodes)
    expect(session.learned!.noted).toBe(true)
    playground.stop()
    expect(playground.records.runs).toHaveLength(1)
    playground.play()
    expect([playground.seed, playground.state]).toEqual([2, 'playing'])
    playground.pause()
  })
})

test('where moves fly by, the map has a moment first, and numbers and words have it a frame later', () => {
  const { playground } = ready()
  const { screen: shown } = playground
  const first = shown.told
  playground.goTo(0)
  expect([shown.drawn === shown.told, shown.told === first]).toEqual([false, true])
  expect([shown.isBusy, shown.isFleeting]).toEqual([true, true])
  draw()
  expect([shown.drawn === shown.told, shown.isBusy]).toEqual([true, false])
  const second = shown.told
  playground.goTo(0)
  draw()
  expect([shown.told === shown.drawn, shown.told === second]).toEqual([true, false])
})
