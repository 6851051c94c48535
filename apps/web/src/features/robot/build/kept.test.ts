import { cardConfig, defaultConfig } from '@botgarten/simulation'
import { expect, it } from 'vitest'
import { mostKept, robotsFrom, withKept, withoutKept } from './kept.ts'

it('a robot is kept by its name, another takes its place, and it can be left out again', () => {
  const two = withKept(withKept({}, 'Wall-E', cardConfig)!, 'Bo', defaultConfig)!
  expect(Object.keys(two)).toEqual(['Bo', 'Wall-E'])
  expect(withKept(two, 'Bo', cardConfig)!['Bo']).toBe(cardConfig)
  expect(withoutKept(two, 'Bo')).toEqual({ 'Wall-E': cardConfig })
})

it('so many and no more, but one of them may be another', () => {
  let robots = {}
  for (let k = 0; k < mostKept; k++) robots = withKept(robots, `robot ${k}`, cardConfig)!
  expect(withKept(robots, 'one more', cardConfig)).toBeNull()
  expect(withKept(robots, 'robot 3', defaultConfig)).toMatchObject({ 'robot 3': defaultConfig })
})

it('of what is no robot nothing is taken', () => {
  const odd = {
    a: cardConfig,
    b: { ...cardConfig, trackWidth: -1 },
    c: null,
    '': cardConfig,
    ['x'.repeat(41)]: cardConfig,
  }
  expect(robotsFrom(JSON.parse(JSON.stringify(odd)))).toEqual({ a: cardConfig })
  for (const data of [null, [], 'robots', 3]) expect(robotsFrom(data)).toEqual({})
  expect(robotsFrom(JSON.parse('{"__proto__": {"wheelDiameter": 3}}'))).toEqual({})
})
