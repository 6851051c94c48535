import { createLab, type Document } from '@botgarten/lab'
import { drawWay, driveSeconds, type MapFile } from '@botgarten/maps'
import { followerProgram } from '@botgarten/maps/follower'
import { cardConfig, paintFloor, TICKS_PER_SECOND } from '@botgarten/simulation'

/** A road in one direction. */
export type RoadName = readonly [from: number, to: number]

/** The robot stands on the goal when it is so near, in cm. */
const ARRIVED = 4

/** Every road of a map in each direction that its drawing has. Rooms of a grid have doors and no roads. */
export const roadsToTry = ({ roads, grid }: MapFile): readonly RoadName[] =>
  grid ? [] : Object.keys(roads).map((name) => name.split('-').map(Number) as [number, number])

/** Does the follower of the toolbox drive this road to its end? By simulation, in the time that such a road needs and a fifth more. */
export function drivesRoad(map: MapFile, road: RoadName): boolean {
  const { scene, points } = drawWay(map, road)
  const { starts, ...floor } = scene
  const robot = { id: 'bo', pose: starts[0]!, program: 'main', brain: '', config: cardConfig }
  const world = { ...floor, robots: [robot] }
  const document: Document = { programs: { main: followerProgram() }, brains: {}, world }
  const lab = createLab()
  lab.load(document, paintFloor(world), { seed: 1, checks: [] })
  lab.start()
  const seconds = 1.2 * driveSeconds(map, road) + 3
  for (let second = 0; second < seconds && lab.view().phase === 'running'; second++)
    lab.advance(TICKS_PER_SECOND)
  const { x, y } = lab.view().robots[0]!.pose
  const [dx, dy] = [x - points.at(-1)!.x, y - points.at(-1)!.y]
  return dx * dx + dy * dy <= ARRIVED * ARRIVED
}
