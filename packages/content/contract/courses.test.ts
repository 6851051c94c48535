// Contract of every course on which brains race: its world and its brains are there, and a robot can stand at each start.
import { laneKinds, type Racer } from '@botgarten/experiments/brain-race'
import { createLab } from '@botgarten/lab'
import { tableOf } from '@botgarten/lab/trying'
import { describe, expect, test } from 'vitest'
import { effortOf, triedAgain } from '../answers/index.ts'
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
    const robots = [{ ...world.robots[0]!, pose: course.starts[0]! }]
    const night = triedAgain(racer, { ...world, robots }, content.floorOf(world))
    expect(Object.values(racer.tables!)).toEqual([tableOf(night.state)])
  })

  test.each(laneKinds)('its brain "%s" has cost what making it again costs (npm run efforts)', (kind) => {
    const racer = content.racer(course.id, kind)
    if (!racer) return
    const ground = { course, world, floor: content.floorOf(world) }
    const timed = (effort: Racer['effort'] = {}) => ({ ...effort, computer: 'computer' in effort })
    expect(timed(racer.effort)).toEqual(timed(effortOf(ground, kind, racer, () => 0)))
    expect(racer.effort?.computer ?? 1).toBeGreaterThan(0)
  })

  test('has the brains that it names, and no others', () => {
    const named = laneKinds.filter((kind) => course.racers[kind])
    expect(laneKinds.filter((kind) => content.racer(course.id, kind))).toEqual(named)
    expect(named.length).toBeGreaterThanOrEqual(2)
  })
})
