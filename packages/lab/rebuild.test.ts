import type { Block } from '@botgarten/blocks'
import { cardConfig, paintFloor, type Obstacle, type Pose, type World } from '@botgarten/simulation'
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { createLab, type Document } from './index.ts'

const thing = (id: string, x: number, y: number, fixed = true): Obstacle => ({
  id,
  shape: { kind: 'rectangle', width: 30, height: 30 },
  pose: { x, y, heading: 0 },
  fixed,
  colour: '#0057A6',
})

const world: World = {
  size: { width: 400, height: 400 },
  floor: { colour: '#FFFFFF' },
  areas: [],
  lines: [],
  obstacles: [thing('crate', 200, 160, false)],
  robots: [
    { id: 'bo', pose: { x: 200, y: 100, heading: 90 }, program: 'main', brain: '', config: cardConfig },
  ],
}

const number = (id: string, value: number): Block => ({
  id,
  type: 'math_number',
  fields: { NUM: String(value) },
})
const drive: Block = {
  id: 'drive',
  type: 'robActions_motorDiff_on_for',
  fields: { DIRECTION: 'FOREWARD' },
  values: { POWER: number('power', 50), DISTANCE: number('way', 250) },
}
const blocks: Block[] = [{ id: 'start', type: 'robControls_start' }, drive]
const document: Document = {
  programs: { main: { stacks: [{ x: 0, y: 0, blocks }], config: { stacks: [] } } },
  world,
  brains: {},
}

function running(ticks: number) {
  const lab = createLab()
  lab.load(document, paintFloor(world), { seed: 1, checks: [] })
  lab.start()
  lab.advance(ticks)
  return lab
}

const rebuild = (lab: ReturnType<typeof running>, next: World) =>
  lab.rebuild({ ...lab.document(), world: next }, paintFloor(next))
const withThings = (...obstacles: Obstacle[]): World => ({ ...world, obstacles })
const crate = world.obstacles[0]!
/** How far the crate is from there: what is put down beside a robot that touches it is a hair off. */
function awayFrom({ x, y }: Pose, lab: ReturnType<typeof running>) {
  const { pose } = lab.view().obstacles[0]!
  return Math.hypot(pose.x - x, pose.y - y)
}

describe('rule 9: building while a program runs', () => {
  it('the program goes on, and whoever is in both worlds stays where it is', () => {
    const lab = running(120)
    const { robots, obstacles, tick, phase } = lab.view()
    rebuild(lab, withThings(crate, thing('new', 50, 50)))
    const after = lab.view()
    expect({ ...after.robots[0], rays: null }).toEqual({ ...robots[0], rays: null })
    expect(after.obstacles[0]).toEqual(obstacles[0])
    expect([after.tick, after.phase]).toEqual([tick, phase])
    lab.advance(60)
    expect(lab.view().robots[0]!.pose.y).toBeGreaterThan(robots[0]!.pose.y + 1)
  })

  it('the way back begins there: no moment of another world comes back', () => {
    const lab = running(120)
    rebuild(lab, withThings(crate, thing('new', 50, 50)))
    const { robots } = lab.view()
    lab.advance(60)
    lab.goTo(120)
    expect(lab.view().robots[0]!.pose).toEqual(robots[0]!.pose)
    lab.goTo(30)
    expect(lab.view().tick).toBe(120)
    expect(lab.view().obstacles.map(({ id }) => id)).toEqual(['crate', 'new'])
  })

  it('rule 8: replay from there gives the same bits', () => {
    const lab = running(100)
    rebuild(lab, withThings(crate, thing('new', 205, 330)))
    lab.advance(400)
    const there = lab.hash()
    lab.goTo(150)
    lab.goTo(500)
    expect(lab.hash()).toBe(there)
  })

  it('a finished program ends its run in time, whatever is built at the same time', () => {
    const way = { ...drive, values: { ...drive.values, DISTANCE: number('way', 5) } }
    const main = { stacks: [{ x: 0, y: 0, blocks: [blocks[0]!, way] }], config: { stacks: [] } }
    const endOf = (change: (lab: ReturnType<typeof running>) => void) => {
      const lab = createLab()
      // A check of one second lets the run last one second longer than the program.
      const checks = [{ id: 'n', kind: 'near', numbers: { obstacle: 'crate', cm: 1 }, seconds: 1 }]
      lab.load({ ...document, programs: { main } }, paintFloor(world), { seed: 1, checks })
      lab.start()
      while (!lab.state().threads[0]!.ended) lab.advance(1)
      lab.advance(10)
      change(lab)
      expect(lab.view().phase).toBe('running')
      while (lab.view().phase === 'running') lab.advance(1)
      return lab.view().tick
    }
    expect(endOf((lab) => rebuild(lab, withThings(crate, thing('new', 50, 50))))).toBe(endOf(() => {}))
  })

  it('what is taken back stands where it stood, and starts from where it started', () => {
    const lab = running(300)
    const pushed = lab.view().obstacles[0]!.pose
    expect(pushed.y).toBeGreaterThan(crate.pose.y + 20)
    rebuild(lab, withThings())
    lab.rebuild({ ...lab.document(), world }, undefined, { crate: pushed })
    expect(awayFrom(pushed, lab)).toBeLessThan(1)
    expect(lab.document().world.obstacles).toEqual([crate])
    lab.reset()
    expect(lab.view().obstacles[0]!.pose).toEqual(crate.pose)
  })

  it('a move that is taken back leaves the start as it was', () => {
    const lab = running(300)
    const pushed = lab.view().obstacles[0]!.pose
    lab.stop()
    lab.place('crate', { x: 40, y: 40, heading: 0 })
    expect(lab.document().world.obstacles[0]!.pose).toEqual({ x: 40, y: 40, heading: 0 })
    lab.place('crate', pushed, crate.pose)
    expect(awayFrom(pushed, lab)).toBeLessThan(1)
    expect(lab.document().world.obstacles).toEqual([crate])
  })

  it('a thing that is put on the robot comes to lie beside it, and the file knows where', () => {
    const lab = running(60)
    const { x, y } = lab.view().robots[0]!.pose
    rebuild(lab, withThings(crate, { ...thing('new', x, y), shape: { kind: 'circle', radius: 8 } }))
    const put = lab.view().obstacles[1]!.pose
    expect(Math.hypot(put.x - x, put.y - y)).toBeGreaterThan(14)
    expect(lab.view().robots[0]!.pose).toMatchObject({ x, y })
    expect(lab.document().world.obstacles[1]!.pose).toEqual(put)
  })

  it('what was taken away is gone, and nobody touches it any more', () => {
    const lab = running(300)
    expect(lab.view().robots[0]!.touching).toEqual(['crate'])
    rebuild(lab, withThings())
    expect(lab.view().robots[0]!.touching).toEqual([])
    expect(lab.view().obstacles).toEqual([])
  })

  it('another start pose puts the robot there', () => {
    const lab = running(60)
    const pose = { x: 60, y: 340, heading: 0 }
    rebuild(lab, { ...world, robots: [{ ...world.robots[0]!, pose }] })
    expect(lab.view().robots[0]!.pose).toEqual(pose)
  })

  it('in a smaller world everybody is on the floor', () => {
    const lab = running(200)
    rebuild(lab, { ...world, size: { width: 80, height: 80 } })
    for (const { pose } of [...lab.view().robots, ...lab.view().obstacles]) {
      expect(pose.x).toBeLessThan(80)
      expect(pose.y).toBeLessThan(80)
    }
    lab.advance(60)
  })

  it('any sequence of building and driving stays in order and replays', () => {
    const put = fc.record({
      id: fc.constantFrom('a', 'b', 'c', 'crate'),
      x: fc.integer({ min: -50, max: 450 }),
      y: fc.integer({ min: -50, max: 450 }),
      fixed: fc.boolean(),
    })
    fc.assert(
      fc.property(fc.array(put, { maxLength: 6 }), (puts) => {
        const lab = running(30)
        let things: readonly Obstacle[] = world.obstacles
        for (const { id, x, y, fixed } of puts) {
          things = [...things.filter((one) => one.id !== id), thing(id, x, y, fixed)]
          rebuild(lab, withThings(...things))
          lab.advance(20)
        }
        const { tick } = lab.view()
        const hash = lab.hash()
        lab.goTo(tick - 10)
        lab.goTo(tick)
        expect(lab.hash()).toBe(hash)
        expect(lab.view().obstacles).toHaveLength(things.length)
      }),
      { numRuns: 40, seed: 4 },
    )
  })
})
