import type { LearningOutline } from '@botgarten/programs'
import { fetchWords } from '#words/message.ts'
import { riddenLine } from '#figures/map/roads.ts'
import Signs from '#figures/map/Signs.svelte'
import { loadStage, courseOn, type Stage } from '#figures/map/stage.ts'

/** A map's drawing with its parts of the moment: each drawing has its own. */
interface DrawnMap {
  readonly stage: Stage
  readonly stations: SVGGElement
  /** Stations of the way that was learned. */
  readonly found: readonly number[] | null
  readonly Signs: typeof Signs
  readonly lineOf: (way: readonly number[]) => string
}

/** @throws Error where there is no such map: a mistake in the content */
export async function drawMap(id: string, learned?: LearningOutline): Promise<DrawnMap> {
  const [stage] = await Promise.all([loadStage(id), fetchWords('blocks-q-learning')])
  if (!stage) throw new Error(`There is no map "${id}".`)
  const found = learned ? learn(stage, learned) : null
  const seen = stage.map.stations.map((_, station) => found?.includes(station) ?? false)
  stage.picture.dress(seen, null)
  stage.picture.cover(
    seen.map(() => true),
    new Map(),
  )
  const lineOf = (way: readonly number[]) =>
    way
      .slice(1)
      .map((to, at) => riddenLine(stage.roads, way[at]!, to))
      .join('')
  return { stage, stations: stage.picture.stations, found, Signs, lineOf }
}

function learn(stage: Stage, outline: LearningOutline): readonly number[] | null {
  const course = courseOn(stage, outline, 1)
  course?.advance(outline.moves)
  return course?.way().states ?? null
}
