import { knowMaps, type Block } from '@botgarten/blocks'
import { afterEach, beforeEach, expect, it } from 'vitest'
import { followMap } from './map-ends.ts'
import { Bench } from './test-bench.ts'

let bench: Bench
const map: Block = {
  ...{ id: 'map', type: 'ai_q_learning_states_and_actions_map' },
  fields: { MAP: 'MAP_RAILWAY', START: '3', FINISH: '1' },
}
const fields = () => ['MAP', 'START', 'FINISH'].map((name) => String(bench.block('map').getFieldValue(name)))

beforeEach(() => {
  const stations = { railway: 6, cliff: 48, lake: 16 }
  knowMaps({ maps: Object.keys(stations), stations, ends: { railway: [3, 1], cliff: [36, 47] } })
  bench = new Bench(map)
  bench.workspace.addChangeListener(followMap(bench.workspace))
})
afterEach(() => bench.dispose())

it('start and goal follow the map that is chosen in its block, and come back with it in one step', () => {
  bench.block('map').setFieldValue('MAP_CLIFF', 'MAP')
  bench.settle()
  expect(fields()).toEqual(['MAP_CLIFF', '36', '47'])
  bench.undo()
  expect(fields()).toEqual(['MAP_RAILWAY', '3', '1'])
  bench.redo()
  expect(fields()).toEqual(['MAP_CLIFF', '36', '47'])
})

it('a map whose ends are not known changes neither', () => {
  bench.block('map').setFieldValue('MAP_LAKE', 'MAP')
  bench.settle()
  expect(fields()).toEqual(['MAP_LAKE', '3', '1'])
})
