// Contract of every course on which brains race: its world and its brains are there, and a robot can stand at each start.
import { laneKinds } from '@botgarten/experiments/brain-race'
import { createLab } from '@botgarten/lab'
import { beginNight, tableOf, ticksOf } from '@botgarten/lab/trying'
import { tryingIn } from '@botgarten/programs'
import { describe, expect, test } from 'vitest'
import { content } from '../files.ts'

describe.each(content.courses)('the course $id', (course) => {
  const world = content.world(course.world)!

  test('has free starts, of which some are sealed', () => {
    const lab = createLab()
    const document = { programs: {}, brains: {}, world }
    lab.load(document, content.floorOf(world), { seed: 1, checks: [] })
    for (const start of course.starts) {
      const { x, y } = lab.place(world.robots[0]!.id, start)
      expect([x, y]).toEqual([start.x, start.y])
    }
    expect(course.shown).toBeLessThan(course.starts.length)
  })

  test('has a table that is learned again from its seed, on the first start alone', () => {
    const racer = content.racer(course.id, 'trying')
    if (!racer) return
    const { id, trial, minutes } = tryingIn(Object.values(racer.programs)[0]!)!
    const [placement] = world.robots
    const robots = [{ ...placement!, pose: course.starts[0]! }]
    const night = beginNight({ ...world, robots }, content.floorOf(world), trial)
    night.advance(ticksOf(minutes))
    expect(racer.tables).toEqual({ [id]: tableOf(night.state) })
  })

  test('has the brains that it names, and no others', () => {
    const named = laneKinds.filter((kind) => course.racers[kind])
    expect(laneKinds.filter((kind) => content.racer(course.id, kind))).toEqual(named)
    expect(named.length).toBeGreaterThanOrEqual(2)
  })
})
