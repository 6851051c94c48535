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
const blocks = {
  setFields: (block: string, fields: object) => void steps.push({ block, ...fields }),
  setClosed: (map: string, roads: LearningOutline['closed']) => void steps.push({ map, roads }),
}
const edits = (of: LearningOutline | null = outline) =>
  new BlockEdits(
    () => of,
    blocks,
    () => true,
  )
beforeEach(() => (steps = []))

test('an edit keeps a change of the blocks that the editor has not reported yet', () => {
  let known = outline
  const settle = () => (known = { ...outline, start: 4, closed: [[4, 5]], pay: { own: { '7': 1 } } })
  for (const edit of [
    (one: BlockEdits) => one.setStation('FINISH', 5),
    (one: BlockEdits) => one.setRoad(1, 2, true, false),
    (one: BlockEdits) => one.setOwn(['3'], 2),
    (one: BlockEdits) => one.setMap('city', 0, 1),
  ]) {
    known = outline
    edit(new BlockEdits(() => known, blocks, settle))
  }
  expect(steps).toEqual([
    { block: 'map', START: '4', FINISH: '5' },
    { map: 'map', roads: [[4, 5], [1, 2]] }, // prettier-ignore
    { block: 'map', REWARDS: expect.stringContaining('7') as string },
    { map: 'map', roads: [] },
    expect.objectContaining({ START: '0', FINISH: '1' }),
  ])
})

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
