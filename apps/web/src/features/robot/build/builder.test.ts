import { cardConfig } from '@botgarten/simulation'
import { afterEach, beforeEach, expect, it } from 'vitest'
import { closeSessions, sessionOf } from '#lab/testing/session.ts'
import { freshDevice } from '#storage/testing/device.ts'
import { RobotBuilder } from './builder.svelte.ts'

beforeEach(freshDevice)
afterEach(closeSessions)

function build() {
  const { session } = sessionOf()
  const builder = new RobotBuilder(session)
  builder.change(cardConfig)
  return { session, builder }
}

it('a sensor that is taken sits at the first free port and is chosen', () => {
  const { session, builder } = build()
  builder.take('gyro')
  expect(session.config.sensors['4']?.kind).toBe('gyro')
  expect(builder.sensor).toBe('4')
})

it('where no port is free, nothing changes and that is said until one is', () => {
  const { session, builder } = build()
  builder.take('gyro')
  const before = session.config
  builder.take('sound')
  expect([builder.full, session.config]).toEqual([true, before])
  builder.remove('1')
  expect([builder.full, builder.sensor]).toEqual([false, null])
})

it('a sensor let go of over a port is plugged in there, over the robot it sits there, elsewhere it goes back', () => {
  const { session, builder } = build()
  builder.drop('gyro', '2', undefined)
  expect(session.config.sensors['2']?.kind).toBe('gyro')
  builder.drop('ultrasonic', undefined, { x: 2, y: -3 })
  expect(session.config.sensors['4']).toMatchObject({ kind: 'ultrasonic', x: 3, y: -2 })
  const before = session.config
  builder.remove('4')
  builder.drop('sound', undefined, { x: 40, y: 0 })
  expect(session.config.sensors).not.toHaveProperty('4')
  expect(before.sensors).toHaveProperty('4')
})

it('a sensor that moves over stays chosen, and every change is one step to undo', () => {
  const { session, builder } = build()
  const before = session.undo.count
  builder.select('1')
  builder.moveOver('4')
  expect([builder.sensor, session.config.sensors['4']]).toEqual(['4', cardConfig.sensors['1']])
  expect(session.undo.count).toBe(before + 1)
})

it('a motor or a sensor is chosen, never both', () => {
  const { builder } = build()
  builder.select('1')
  builder.selectMotor('B')
  expect([builder.sensor, builder.motor]).toEqual([null, 'B'])
  builder.select('2')
  expect([builder.sensor, builder.motor]).toEqual(['2', null])
})
