import type { LearningOutline } from '@botgarten/programs'
import { beforeEach, expect, test } from 'vitest'
import { BlockEdits } from './block-edits.ts'

const outline: LearningOutline = {
  ...{
    blocks: { map: 'map', behaviour: 'how' },
    map: 'railway',
    start: 3,
    goal: 1,
    episodes: 10,
    moves: 100,
  },
  closed: [[3, 2], [2, 3]], // prettier-ignore
  settings: { rules: 'standard', algorithm: 'q', alpha: 0.5, gamma: 0.8, nu: 0.1, rho: 0.5 },
  pay: { own: { '3': 10, '2-5': -5 } },
}
let steps: unknown[] = []
const edits = (of: LearningOutline | null = outline) =>
  new BlockEdits(() => of, {
    setFields: (block, fields) => steps.push({ block, ...fields }),
    setClosed: (map, roads) => steps.push({ map, roads }),
  })
beforeEach(() => (steps = []))

test('a station becomes the start in one step', () => {
  edits().setStation('START', 5)
  expect(steps).toEqual([{ block: 'map', START: '5', FINISH: '1' }])
})

test('start and goal change places in one step rather than become one', () => {
  edits().setStation('START', 1)
  edits().setStation('FINISH', 3)
  expect(steps).toEqual([
    { block: 'map', START: '1', FINISH: '3' },
    { block: 'map', START: '1', FINISH: '3' },
  ])
})

test('a road is closed or opened in each direction, the others stay', () => {
  edits().setRoad(2, 3, false, true)
  edits().setRoad(0, 1, true, true)
  expect(steps).toEqual([
    { map: 'map', roads: [[3, 2]] },
    { map: 'map', roads: [[3, 2], [2, 3], [0, 1], [1, 0]] }, // prettier-ignore
  ])
  expect([edits().isClosed(3, 2), edits().isClosed(0, 1)]).toEqual([true, false])
})

test('roads that share one station with it stay closed', () => {
  const closed = [[3, 2], [2, 3], [3, 5], [1, 2], [2, 4]] as const // prettier-ignore
  edits({ ...outline, closed }).setRoad(2, 3, false, false)
  expect(steps).toEqual([{ map: 'map', roads: [[3, 5], [1, 2], [2, 4]] }]) // prettier-ignore
})

test('own rewards come, change and go', () => {
  edits().setOwn(['4'], 2.5)
  edits().setOwn(['3'], 0)
  edits().setOwn(['2-5', '5-2'], 1)
  expect(steps).toEqual([
    { block: 'map', REWARDS: '3:10 4:2.5 2-5:-5' },
    { block: 'map', REWARDS: '2-5:-5' },
    { block: 'map', REWARDS: '3:10 2-5:1 5-2:1' },
  ])
})

test('without blocks nothing happens', () => {
  edits(null).setStation('START', 1)
  edits(null).setOwn(['1'], 1)
  edits({ ...outline, blocks: { map: 'map' } }).setBehaviour('RHO', '0.3')
  expect(steps).toEqual([])
})
