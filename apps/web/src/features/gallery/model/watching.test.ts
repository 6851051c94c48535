import { cardProject } from '@botgarten/content/document'
import { content } from '@botgarten/content/files'
import type { Project } from '@botgarten/programs'
import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import type { Packs } from '#lab/opening.ts'
import { screen } from '#lab/testing/session.ts'
import { Watching } from './watching.svelte.ts'

const { card, world } = content.card('friendship')!
const onWhite = { ...world, floor: { colour: '#FFFFFF' } }
const project: Project = cardProject(onWhite, card, content.program('friendship', 'solution')!, 'friendship')
const [bo] = project.world.robots as [Project['world']['robots'][number]]
/** Where the first robot starts; angles are computed in radians. */
const start = { ...bo.pose, heading: expect.closeTo(bo.pose.heading, 9) as number }
/** It starts elsewhere, and has no sensors. */
const rival: Project = {
  ...project,
  world: {
    ...project.world,
    robots: [{ ...bo, pose: { x: 1, y: 2, heading: 0 }, config: { ...bo.config, sensors: {} } }],
  },
}

let loaded: Pick<Project, 'programs'>[]
const packs: Packs = {
  loadLearning: () => Promise.resolve(),
  loadFor(one) {
    loaded.push(one)
    return Promise.resolve(false)
  },
}
let draw: ReturnType<typeof screen>
beforeEach(() => {
  loaded = []
  draw = screen()
})
afterEach(() => void vi.unstubAllGlobals())

test('a snapshot drives when it is started, pauses, and goes back to its beginning', async () => {
  const watching = await Watching.open(project, packs)
  const stop = watching.run()
  const pose = () => watching.world.robots[0]!.pose
  const { x } = bo.pose
  expect([watching.hasGhost, watching.ghost, watching.running]).toEqual([false, null, false])
  expect(pose()).toEqual(start)
  expect(watching.world.obstacles).toHaveLength(project.world.obstacles.length)
  watching.toggle()
  expect(watching.running).toBe(true)
  for (let frame = 0; frame < 20; frame++) draw(50)
  expect(Math.abs(pose().x - x)).toBeGreaterThan(1)
  watching.toggle()
  expect([watching.running, watching.paused]).toEqual([false, true])
  watching.toggle()
  expect([watching.running, watching.paused]).toEqual([true, false])
  watching.back()
  expect([watching.running, pose()]).toEqual([false, start])
  stop()
})

test('a rival starts as a ghost where the snapshot starts, with its own sensors, and both drive', async () => {
  const watching = await Watching.open(project, packs, rival)
  const stop = watching.run()
  expect(loaded).toContain(rival)
  expect(watching.hasGhost).toBe(true)
  expect(watching.ghost).toMatchObject({ config: { sensors: {} }, pose: start })
  expect(watching.world.robots).toHaveLength(1)
  watching.speed = 2
  watching.toggle()
  for (let frame = 0; frame < 20; frame++) draw(50)
  // A network without sensors gives 0 to both wheels: only the snapshot has moved.
  expect(Math.abs(watching.world.robots[0]!.pose.x - bo.pose.x)).toBeGreaterThan(1)
  expect(watching.ghost!.pose).toEqual(start)
  watching.toggle()
  expect([watching.running, watching.paused]).toEqual([false, true])
  watching.back()
  expect(watching.world.robots[0]!.pose).toEqual(start)
  stop()
})
