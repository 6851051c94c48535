import { expect, test } from 'vitest'
import { cardConfig, defaultConfig } from '../configs.ts'
import type { RobotConfig, SensorKind, SensorPort } from '../types.ts'
import { placeFor, withoutSensor, withSensor } from './places.ts'

const kinds: readonly SensorKind[] = [
  'ultrasonic',
  'colour',
  'touch',
  'gyro',
  'infrared',
  'sound',
  'compass',
  'position',
]
const ports: readonly SensorPort[] = ['1', '2', '3', '4']
const bare: RobotConfig = { ...cardConfig, sensors: {} }

test('the first sensors go where the robot out of the box has them', () => {
  for (const [port, sensor] of Object.entries(defaultConfig.sensors))
    expect(placeFor(sensor.kind, withoutSensor(defaultConfig, port as SensorPort))).toEqual(sensor)
})

test.each(kinds.filter((kind) => kind !== 'touch'))('four of %s lie on four places', (kind) => {
  const full = ports.reduce((config, port) => withSensor(config, port, placeFor(kind, config)), bare)
  const places = Object.values(full.sensors).map(({ x, y }) => `${x} ${y}`)
  expect(new Set(places).size).toBe(4)
})

test('of two bumpers one goes behind', () => {
  const one = withSensor(bare, '1', placeFor('touch', bare))
  expect(placeFor('touch', one)).toMatchObject({ x: -6.7, angle: 180 })
})

test('a sensor is taken out without a trace, the others stay as they are', () => {
  expect(withoutSensor(cardConfig, '2').sensors).toEqual({
    '1': cardConfig.sensors['1'],
    '3': cardConfig.sensors['3'],
  })
})
