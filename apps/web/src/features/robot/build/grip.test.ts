import type { SensorPlace } from '@botgarten/simulation'
import { expect, it } from 'vitest'
import { gripAt, placeIn } from './grip.ts'
import { handleOf, spotOf } from './placing.ts'

const eye: SensorPlace = { kind: 'ultrasonic', x: 5, y: 2, angle: 20 }

it('a mark does not jump when it is taken beside its middle, and follows the pointer from there', () => {
  const { x, y } = spotOf(eye)
  const grip = gripAt('move', eye, { x: x + 0.7, y: y - 0.4 })
  expect(placeIn(grip, eye, { x: x + 0.7, y: y - 0.4 })).toEqual(eye)
  expect(placeIn(grip, eye, { x: x + 1.7, y: y - 2.4 })).toEqual({ ...eye, x: 7, y: 1 })
})

it('a handle turns the sensor towards the pointer and leaves it where it is', () => {
  const grip = gripAt('turn', eye, handleOf(eye, 5.4))
  expect(placeIn(grip, eye, handleOf({ ...eye, angle: -35 }, 5.4))).toEqual({ ...eye, angle: -35 })
})
