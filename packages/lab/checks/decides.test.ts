import type { Block } from '@botgarten/blocks'
import { paintFloor } from '@botgarten/simulation'
import { describe, expect, it } from 'vitest'
import { createLab, type Check } from '../index.ts'
import { forever, net, program, turn, worldWith } from '../testing/scene.ts'

const eyesDecide: Check = { id: 'eyes', kind: 'eyesDecide', numbers: { percent: 2 }, seconds: 0.1 }

type Weights = readonly [leftLeft: number, leftRight: number, rightLeft: number, rightRight: number]

/** Bo drives for some seconds before two boxes. */
function driven(blocks: readonly Block[], [ll, lr, rl, rr]: Weights, checks = [eyesDecide], noise = 0) {
  const world = worldWith()
  const robots = world.robots.map((robot) => ({
    ...robot,
    pose: { ...robot.pose, heading: 70 },
    config: { ...robot.config, noise },
  }))
  const lab = createLab()
  const document = { programs: { main: program(...blocks) }, world: { ...world, robots }, brains: {} }
  lab.load(document, paintFloor(world), { seed: 3, checks })
  lab.setWeight('net', 'eyeLeft', 'wheelLeft', ll)
  lab.setWeight('net', 'eyeLeft', 'wheelRight', lr)
  lab.setWeight('net', 'eyeRight', 'wheelLeft', rl)
  lab.setWeight('net', 'eyeRight', 'wheelRight', rr)
  lab.start()
  lab.advance(1200)
  return lab
}
const decides = (...of: Parameters<typeof driven>) => driven(...of).view().checks[0]!.passed
const netOnly = [forever(net())]

describe('eyesDecide: had each eye seen what the other saw, Bo would have turned the other way', () => {
  it('crossed links and straight ones decide', () => {
    expect(decides(netOnly, [0, 0.8, 0.8, 0])).toBe(true)
    expect(decides(netOnly, [0.8, 0, 0, 0.8])).toBe(true)
    expect(decides(netOnly, [0, 0.8, 0.7, 0])).toBe(true)
  })

  it('the same weights for both eyes do not, one eye alone does not, and no eye does not', () => {
    expect(decides(netOnly, [0.5, 0.6, 0.5, 0.6])).toBe(false)
    expect(decides(netOnly, [0.5, 0.4, 0.5, 0.4])).toBe(false)
    expect(decides(netOnly, [0.5, 0.6, 0, 0])).toBe(false)
    expect(decides(netOnly, [0, 0, 0, 0])).toBe(false)
    expect(decides([forever(turn('round', 40, 90))], [0, 0, 0, 0])).toBe(false)
  })

  it('a turn of half a percent is one where the check asks for no more', () => {
    const slight = [{ ...eyesDecide, numbers: { percent: 0.1 }, seconds: 8 }]
    expect(decides(netOnly, [0.25, 0.255, 0.255, 0.25], slight)).toBe(true)
    expect(decides(netOnly, [0.255, 0.25, 0.25, 0.255], slight)).toBe(true)
  })

  it('a network that only lies about decides nothing', () => {
    expect(decides([forever(turn('round', 40, 90), { ...net(), disabled: true })], [0, 0.8, 0.8, 0])).toBe(
      false,
    )
  })

  it('so do plain blocks that look with both eyes', () => {
    const block = (id: string, type: string, rest: Partial<Block>): Block => ({ id, type, ...rest })
    const eye = (id: string, port: number) =>
      block(id, 'robSensors_ultrasonic_getSample', {
        mutation: { attrs: { mode: 'DISTANCE' } },
        fields: { MODE: 'DISTANCE', SENSORPORT: String(port) },
      })
    const wheel = (id: string, port: string, power: Block) =>
      block(id, 'robActions_motor_on', { fields: { MOTORPORT: port }, values: { POWER: power } })
    const weights = [0, 0, 0, 0] as const
    const both = [wheel('l', 'C', eye('r2', 3)), wheel('r', 'B', eye('l2', 2))]
    expect(decides([forever(...both)], weights)).toBe(true)
    const same = [wheel('l', 'C', eye('r2', 2)), wheel('r', 'B', eye('l2', 2))]
    expect(decides([forever(...same)], weights)).toBe(false)
  })

  it.each([0, 10])('looking at it changes nothing in the run (noise %d)', (noise) => {
    for (const weights of [
      [0, 0.8, 0.8, 0],
      [0.5, 0.6, 0.5, 0.6],
    ] as const) {
      const [looked, plain] = [
        driven(netOnly, weights, [eyesDecide], noise),
        driven(netOnly, weights, [], noise),
      ]
      expect(looked.hash()).toBe(plain.hash())
      expect(looked.state().threads).toEqual(plain.state().threads)
    }
  })
})

describe('netDecides: without its network Bo would have turned otherwise', () => {
  const netDecides: Check = { id: 'net', kind: 'netDecides', numbers: { percent: 2 }, seconds: 0.1 }
  const netDrives = (blocks: readonly Block[], weights: Weights) => decides(blocks, weights, [netDecides])

  it('a network that turns Bo decides, also with the same weights for both eyes', () => {
    expect(netDrives(netOnly, [0, 0.8, 0.8, 0])).toBe(true)
    expect(netDrives(netOnly, [0.5, 0.6, 0.5, 0.6])).toBe(true)
  })

  it('one that drives straight on, or not at all, decides nothing', () => {
    expect(netDrives(netOnly, [0.5, 0.5, 0, 0])).toBe(false)
    expect(netDrives(netOnly, [0, 0, 0, 0])).toBe(false)
  })

  it('nor does one that is switched off, or whose wheels other blocks set afterwards', () => {
    const other = turn('round', 40, 90)
    expect(netDrives([forever(other, { ...net(), disabled: true })], [0, 0.8, 0.8, 0])).toBe(false)
    const wheel = (id: string, port: string, percent: string): Block => ({
      ...{ id, type: 'robActions_motor_on', fields: { MOTORPORT: port } },
      values: { POWER: { id: `${id}Power`, type: 'math_number', fields: { NUM: percent } } },
    })
    const fixed = [wheel('left', 'C', '20'), wheel('right', 'B', '40')]
    expect(netDrives([forever(net(), ...fixed)], [0, 0.8, 0.8, 0])).toBe(false)
  })
})
