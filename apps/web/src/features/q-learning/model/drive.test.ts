import { addBlocks, knowMaps } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { cardProject } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import type { View } from '@botgarten/lab'
import { placeOf } from '@botgarten/maps'
import { learningIn } from '@botgarten/programs'
import { TICKS_PER_SECOND } from '@botgarten/simulation'
import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { courseOn, type Stage } from '#figures/map/stage.ts'
import { closeSessions, sessionOf } from '#lab/testing/session.ts'
import type { LabUi } from '#lab/ui.svelte.ts'
import { freshDevice } from '#storage/testing/device.ts'
import { Drive, type LearnedWay } from './drive.svelte.ts'

addBlocks(learning)
knowMaps(content)
beforeEach(async () => {
  await freshDevice()
  vi.stubGlobal('requestAnimationFrame', (frame: () => void) => setTimeout(frame))
})
afterEach(() => {
  closeSessions()
  vi.unstubAllGlobals()
})

const { card, world } = content.card('railway')!

/** The railway without its picture, which needs a document. */
const stage = { id: 'railway', map: content.mapFile('railway')!, roads: [] } as unknown as Stage

/** The railway's solution, after all its tries, with these roads closed in both directions. */
function learned(...closed: readonly (readonly [number, number])[]) {
  const { session } = sessionOf(cardProject(world, card, content.program('railway', 'solution')!, 'railway'))
  const outline = learningIn(session.program)!
  const roads = closed.flatMap(([from, to]) => [[from, to] as const, [to, from] as const])
  const course = courseOn(stage, { ...outline, closed: [...outline.closed, ...roads] }, 1)!
  while (!course.over) course.advance(1000)
  const { states: stations } = course.way()
  const way: LearnedWay | null = stations && { course, stage, stations, blocks: outline.blocks }
  const start = vi.fn()
  const drive = new Drive(session, { start } as unknown as LabUi, () => way)
  return { session, way, drive, start }
}

test('a way that was learned is drawn on the floor, and then Bo drives it', async () => {
  const { session, way, drive, start } = learned()
  expect(way!.stations.at(-1)).toBe(1)
  await drive.draw(true)
  expect(session.lab.document.world.lines.length).toBeGreaterThan(0)
  expect(start).toHaveBeenCalledTimes(1)
})

test('a drive counts from where the way begins, and from nowhere else until Bo is put back', async () => {
  const { session, drive } = learned()
  expect(drive.starts).toBeNull()
  const { starts } = session
  session.starts = () => drive.starts ?? starts()
  session.learnFirst = () => false
  await drive.draw(false)
  expect([session.chosenStart, session.lab.document.world.robots[0]!.pose]).toEqual([0, drive.starts![0]])
  session.start()
  expect([session.beganElsewhere, session.noteSuccess()]).toEqual([false, true])
  session.lab.stop()
  session.lab.reset()
  session.apply({ kind: 'progress', after: { starts: [], hints: 0 } })
  const { x, y, heading } = drive.starts![0]!
  session.apply({ kind: 'place', id: session.robotId, after: { x: x + 10, y, heading } })
  session.start()
  expect([session.beganElsewhere, session.noteSuccess(), session.progress.starts]).toEqual([true, false, []])
  session.lab.stop()
  session.toStart()
  expect([session.chosenStart, session.lab.view.robots[0]!.pose]).toEqual([0, drive.starts![0]])
  // The same way, learned once more.
  session.apply({ kind: 'place', id: session.robotId, after: { x: x + 10, y, heading } })
  await drive.draw(false)
  expect(session.chosenStart).toBe(0)
})

test('if all roads to the goal are closed, no way is drawn and Bo does not drive', async () => {
  const { session, way, drive, start } = learned([0, 1], [1, 2])
  expect(way).toBeNull()
  const before = session.lab.document.world
  await drive.draw(true)
  expect(drive.drawFirst()).toBe(false)
  expect(session.lab.document.world).toBe(before)
  expect(start).not.toHaveBeenCalled()
})

test('the drive ends when Bo has stood at the goal for two seconds, and not before', async () => {
  const { session, way, drive } = learned()
  await drive.draw(true)
  const { x, y } = placeOf(stage.map, way!.stations.at(-1)!)
  const stop = vi.spyOn(session.lab, 'stop')
  const at = (tick: number, away: number, percent: number) => {
    const bo = { pose: { x: x + away, y, heading: 0 }, motors: { B: percent, C: percent } }
    drive.endAtGoal({ tick, robots: [bo] } as unknown as View)
  }
  at(0, 30, 0)
  at(1000, 30, 0)
  at(1001, 5, 20)
  at(2000, 5, 20)
  at(2001, 5, 0)
  at(2001 + 2 * TICKS_PER_SECOND - 1, 5, 0)
  expect(stop).not.toHaveBeenCalled()
  at(2001 + 2 * TICKS_PER_SECOND, 5, 0)
  expect(stop).toHaveBeenCalledTimes(1)
})

test('the pale map lies under the floor only while the way of this map lies on it', async () => {
  const { session, drive } = learned()
  const painted = { ...stage, picture: { pale: 'data:image/svg+xml,pale' } } as unknown as Stage
  drive.showMap(painted)
  expect(session.below).toBeNull()
  await drive.draw(false)
  drive.showMap(painted)
  expect(session.below!.url).toBe('data:image/svg+xml,pale')
  expect(session.below!.stations).toEqual(stage.map.stations.map((_, at) => placeOf(stage.map, at)))
  drive.showMap(null)
  expect(session.below).toBeNull()
})

test('map and floor change places: the small one comes to the front, again and again', () => {
  const { drive } = learned()
  const seen = [drive.front]
  for (let press = 0; press < 3; press += 1) {
    drive.swap()
    seen.push(drive.front)
  }
  expect(seen).toEqual(['map', 'floor', 'map', 'floor'])
})

test('a way that is not drawn yet is drawn when Bo is started, and then Bo drives it', async () => {
  const { session, drive, start } = learned()
  expect(drive.drawFirst()).toBe(true)
  await vi.waitFor(() => expect(start).toHaveBeenCalledTimes(1))
  expect(session.lab.document.world.lines.length).toBeGreaterThan(0)
  expect(drive.drawFirst()).toBe(false)
})

test('a way that cannot be drawn is not drawn when Bo is started', () => {
  const { session, way, start } = learned()
  // It turns back at once.
  const back = { ...way!, stations: [3, 4, 3, 2, 1] }
  const drive = new Drive(session, { start } as unknown as LabUi, () => back)
  expect(drive.drawFirst()).toBe(false)
  expect(session.lab.document.world.lines).toEqual([])
})
