import type { RobotView } from '@botgarten/lab'
import type { RobotConfig } from '@botgarten/simulation'
import { onFloor } from './camera.ts'
import type { Command } from './commands.ts'
import type { Point } from './points.ts'
import { labelPlaces } from './rays.ts'
import { sightsOf, type Sight } from './sights.ts'
import type { Scene } from './world.ts'

const ink = '#3A2A20'

/** A sight, and the middle of what is written at it. */
export interface Reading extends Sight {
  readonly label: Point
}

/** What the distance sensors see, in px of the floor's box. */
export function readingsOf(
  robot: RobotView,
  config: RobotConfig,
  { floor, scale, seen }: Pick<Scene, 'floor' | 'scale' | 'seen'>,
): readonly Reading[] {
  const sights = sightsOf(robot, config, floor, scale)
  const places = labelPlaces(
    onFloor(robot.pose, floor, scale),
    sights.map(({ near }) => near),
    seen,
  )
  return sights.map((sight, i) => ({ ...sight, label: places[i]! }))
}

/** What the distance sensors see: a cone each, a line to the nearest thing and what they read of it. In px of the floor's box. */
export function drawSenses(
  robot: RobotView,
  config: RobotConfig,
  scene: Pick<Scene, 'floor' | 'scale' | 'seen' | 'strong'>,
): readonly Command[] {
  const all = readingsOf(robot, config, scene)
  return [...all.flatMap((one) => cone(one, scene.strong)), ...all.flatMap(reading)]
}

const own = ({ infrared }: Sight) => (infrared ? '#B8391C' : '#2F9C95')

function cone(sight: Sight, strong: boolean): readonly Command[] {
  const { cone: points, hit, near } = sight
  const stroke = own(sight)
  return [
    { kind: 'line', points, closed: true, fill: stroke, opacity: strong ? 0.24 : 0.13 },
    {
      kind: 'line',
      points: [near.from, near.to],
      stroke,
      lineWidth: strong ? 6 : 3,
      ...(hit ? {} : { dash: [2, 8] }),
    },
    ...(hit
      ? [{ kind: 'circle' as const, ...near.to, r: 5, fill: stroke, stroke: '#fff', lineWidth: 2 }]
      : []),
  ]
}

const reading = ({ label: { x, y }, ...sight }: Reading): readonly Command[] => [
  {
    kind: 'rect',
    x: x - 23,
    y: y - 13.5,
    width: 46,
    height: 27,
    round: sight.infrared ? 13.5 : 9,
    fill: '#fff',
    stroke: own(sight),
    lineWidth: 2.5,
  },
  {
    kind: 'text',
    x,
    y: y + 6,
    text: String(sight.reading),
    size: 16,
    font: 'title',
    align: 'middle',
    fill: ink,
  },
]
