import { readFileSync } from 'node:fs'
import { content } from '@botgarten/content/files'
import type { RobotConfig } from '@botgarten/simulation'
import { expect, test } from 'vitest'
import { boParts } from './bo-parts.ts'

const { robots } = content.world('friendship')!
const friend = robots[0]!.config
const named = (config: RobotConfig) => boParts(config).map(({ kind, port }) => `${kind} ${port}`)

test('the parts of Bo are those of its configuration, and what every Bo has', () => {
  expect(named(friend).sort()).toEqual(
    ['colour 1', 'display null', 'lamp null', 'ultrasonic 2', 'ultrasonic 3', 'wheel B', 'wheel C'].sort(),
  )
})

test('a sensor that is plugged out is no part, and one inside the body is not seen', () => {
  const config = { ...friend, sensors: { '4': { kind: 'gyro', x: 0, y: 0, angle: 0 } } } as RobotConfig
  expect(named(config).filter((name) => /\d/.test(name))).toEqual([])
})

test('the left wheel is the motor that the configuration has on the left', () => {
  const swapped = { ...friend, drive: { left: 'A', right: 'D' } } as const
  const left = boParts(swapped).filter(({ kind, at }) => kind === 'wheel' && at.x < 0)
  expect(left.map(({ port }) => port)).toEqual(['A'])
})

test('an eye is named where it is drawn: both keep to the same bounds of the head', () => {
  const bounds = (path: string) =>
    readFileSync(new URL(path, import.meta.url), 'utf8').match(/clamp\(0 - [xy], [-\d., ]+\)/g)
  expect(bounds('./bo-parts.ts')).toHaveLength(2)
  expect(bounds('./bo-parts.ts')).toEqual(bounds('../figures/world/BoTop.svelte'))
})
