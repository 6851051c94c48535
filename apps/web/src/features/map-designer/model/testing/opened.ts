import { addRoad, addStation, emptyMap } from '@botgarten/maps/own'
import type { MapDocument, RoadMap } from '@botgarten/programs'
import { newProject } from '#content/new-project.ts'
import { withMap, type OpenedDrawing } from '../projects.ts'

type Place = readonly [x: number, y: number]
type Ends = readonly [from: number, to: number]

/** A map with stations at these places and roads between them; the start is 0, the goal 1. */
export const drawn = (places: readonly Place[], roads: readonly Ends[] = []): RoadMap =>
  roads.reduce(
    (map, [from, to]) => addRoad(map, from, to),
    places.map(([x, y]) => ({ x, y })).reduce(addStation, emptyMap('Pond')),
  )

/** Three stations in a row from left to right, 300 units apart, and a road from each to the next. */
export const row = drawn(
  [
    [200, 500],
    [500, 500],
    [800, 500],
  ],
  [
    [0, 1],
    [1, 2],
  ],
)

/** A project that holds this map alone and was never saved. */
export async function openedWith(map: MapDocument): Promise<OpenedDrawing> {
  const project = withMap(await newProject('Mine', null), 'map', map)
  return { id: 'mine', revision: 0, project, mapId: 'map' }
}
