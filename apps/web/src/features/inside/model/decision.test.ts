import type { NetworkOutline } from '@botgarten/programs'
import { expect, test } from 'vitest'
import { friendship } from '#storage/testing/sample.ts'
import { askedOf, wheelsOf } from './decision.ts'

/** Motor C is the left wheel, motor B the right one. */
const { config } = friendship.world.robots[0]!
type Output = NetworkOutline['outputs'][number]
const output = (id: string, value: string, colour = 'actuator', port = 'OUT'): Output =>
  ({ id, look: { colour, port }, fields: { OUT: value } }) as unknown as Output
const left = output('l', 'MOTORPORT_C')
const right = output('r', 'MOTORPORT_B')
const lamp = output('lamp', 'LED_B', 'display')

test('outputs with a motor of the drive are its wheels, the last one where two have the same', () => {
  expect(wheelsOf([left, right], config)).toEqual({ left: 0, right: 1 })
  expect(wheelsOf([right, left, right], config)).toEqual({ left: 1, right: 2 })
  expect(wheelsOf([output('a', 'MOTORPORT_A'), left], config)).toEqual({ left: 1, right: -1 })
})

test('a lamp is no wheel, whatever the letter of its port, nor is an output without a port', () => {
  expect(wheelsOf([lamp], config)).toEqual({ left: -1, right: -1 })
  expect(wheelsOf([output('n', 'MOTORPORT_C', 'actuator', 'NONE')], config).left).toBe(-1)
})

test('both wheels decide together where Bo turns: the faster left one to the right', () => {
  for (const id of ['l', 'r']) {
    const { kind, decision } = askedOf([lamp, left, right], id, config)!
    expect([kind, decision([0, 60, 20]), decision([0, 20, 60])]).toEqual(['turn', 1, -1])
  }
})

test('a wheel without its partner decides between forward and backward', () => {
  const { kind, decision } = askedOf([lamp, left], 'l', config)!
  expect([kind, decision([0, 30]), decision([0, -30])]).toEqual(['wheel', 1, -1])
})

test('an output without a motor decides whether it is on', () => {
  expect(askedOf([left, right, lamp], 'lamp', config)!.kind).toBe('on')
  expect(askedOf([output('n', 'MOTORPORT_C', 'actuator', 'NONE')], 'n', config)!.kind).toBe('on')
})

test('a neuron that is no output decides nothing', () => {
  expect(askedOf([left, right], 'eye', config)).toBeNull()
})
