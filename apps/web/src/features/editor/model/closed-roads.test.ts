import type { Block } from '@botgarten/blocks'
import { learningIn } from '@botgarten/programs'
import { afterEach, expect, it } from 'vitest'
import { setClosed } from './closed-roads.ts'
import { Bench } from './test-bench.ts'

let bench: Bench
afterEach(() => bench.dispose())

type Roads = readonly (readonly [number, number])[]

const road = (id: string, from: number, to: number): Block => ({
  id,
  type: 'ai_q_barrier_mountain',
  fields: { FROM: String(from), TO: String(to) },
})

const map = (roads: Roads | null): Block => ({
  id: 'map',
  type: 'ai_q_learning_states_and_actions_map',
  fields: { MAP: 'MAP_RAILWAY', START: '3', FINISH: '1' },
  ...(roads && {
    values: {
      OBSTACLE: {
        id: 'closed',
        type: 'rl_obstacles_easy_list',
        mutation: { attrs: { items: String(roads.length), list_type: 'Obstacle' } },
        values: Object.fromEntries(
          roads.map(([from, to], k) => [`ADD${k}`, road(`road${k}`, from, to)] as const),
        ),
      },
    },
  }),
})

const closed = () => learningIn(bench.program())?.closed

it('a road that is closed on the map becomes a row of the block, as one step of undo', () => {
  bench = new Bench(map([]))
  setClosed(bench.workspace, 'map', [[2, 3], [3, 2]]) // prettier-ignore
  bench.settle()
  expect(closed()).toEqual([[2, 3], [3, 2]]) // prettier-ignore
  bench.undo()
  expect(closed()).toEqual([])
  bench.redo()
  expect(closed()).toEqual([[2, 3], [3, 2]]) // prettier-ignore
})

it('a map block without a list gets one', () => {
  bench = new Bench(map(null))
  setClosed(bench.workspace, 'map', [[2, 3]])
  bench.settle()
  expect(closed()).toEqual([[2, 3]])
})

it('a road that is opened takes its row away and leaves the blocks of the others alone', () => {
  bench = new Bench(map([[2, 3], [3, 2], [0, 1]])) // prettier-ignore
  setClosed(bench.workspace, 'map', [[2, 3], [0, 1]]) // prettier-ignore
  bench.settle()
  expect(closed()).toEqual([[2, 3], [0, 1]]) // prettier-ignore
  expect(bench.block('road2')).not.toBeNull()
  expect(bench.block('road1')).toBeNull()
})

it('what stands there twice is kept once', () => {
  bench = new Bench(map([[2, 3], [2, 3]])) // prettier-ignore
  setClosed(bench.workspace, 'map', [[2, 3]])
  bench.settle()
  expect(closed()).toEqual([[2, 3]])
})
