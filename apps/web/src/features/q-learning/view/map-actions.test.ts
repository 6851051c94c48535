import { expect, test } from 'vitest'
import { m } from '#words/message.ts'
import { BlockEdits } from '../model/block-edits.ts'
import { actionsOf } from './map-actions.ts'

/** Of a map on which the road from 3 to 2 is closed in that direction. */
function editsAndSteps() {
  const steps: unknown[] = []
  const outline = {
    ...{
      blocks: { map: 'map', behaviour: 'how' },
      map: 'railway',
      start: 3,
      goal: 1,
      episodes: 10,
      moves: 100,
    },
    closed: [[3, 2]] as [number, number][],
    settings: { rules: 'standard', algorithm: 'q', alpha: 0.5, gamma: 0.8, nu: 0.1, rho: 0.5 } as const,
  }
  const blocks = {
    setFields: (_: string, fields: object) => void steps.push(fields),
    setClosed: (_: string, roads: unknown) => void steps.push(roads),
  }
  const edits = new BlockEdits(
    () => outline,
    blocks,
    () => true,
  )
  return { edits, steps }
}

test('a station can become the start or the goal', () => {
  const { edits, steps } = editsAndSteps()
  for (const action of actionsOf({ kind: 'station', station: 5 }, edits)) action.act()
  expect(steps).toEqual([
    { START: '5', FINISH: '1' },
    { START: '3', FINISH: '5' },
  ])
})

test('a road can be made all that it is not', () => {
  const { edits, steps } = editsAndSteps()
  const actions = actionsOf({ kind: 'road', a: 3, b: 2 }, edits)
  expect(actions.map(({ label }) => label)).toEqual([
    m['q.openRoad'](),
    m['q.closeRoad'](),
    m['q.closeOne']({ from: 2, to: 3 }),
  ])
  for (const action of actions) action.act()
  expect(steps).toEqual([[], [[3, 2], [2, 3]], [[2, 3]]]) // prettier-ignore
})

test('start and goal together are chosen by number, not by buttons', () => {
  expect(actionsOf({ kind: 'ends' }, editsAndSteps().edits)).toEqual([])
})
