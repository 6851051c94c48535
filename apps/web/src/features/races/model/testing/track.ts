import { readFileSync } from 'node:fs'
import { content } from '@botgarten/content/files'
import { layOutWorld } from '@botgarten/learning/q-learning'
import { stageOf } from '#figures/map/testing/stage.ts'
import { taskOn, type Track } from '../track.ts'

/** A built-in map, as a race gets it. */
export function trackOn(id: string): Track {
  const stage = stageOf(id, readFileSync(content.path('maps', id, 'map.svg'), 'utf8'))
  const task = taskOn(id, stage.map)
  return { stage, task, world: layOutWorld(task), name: id, project: null }
}
