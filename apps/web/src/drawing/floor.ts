import type { Area, World } from '@botgarten/simulation'
import { frameWidth } from './camera.ts'
import type { Command } from './commands.ts'
import type { Point } from './points.ts'
import { clockwise, triangleCorners } from './things.ts'

/** Cm between the dots of a floor without a picture. */
const grid = 50
const wood = '#B98A58'
const line = '#4A3428'

function areaOf({ pose, shape, colour: fill }: Area, height: number): Command {
  const inside: Command =
    shape.kind === 'circle'
      ? { kind: 'circle', x: 0, y: 0, r: shape.radius, fill }
      : shape.kind === 'triangle'
        ? { kind: 'line', points: triangleCorners(shape.width, shape.height, shape.tip), closed: true, fill }
        : { x: shape.width / -2, y: shape.height / -2, ...shape, kind: 'rect', fill }
  return {
    kind: 'group',
    x: pose.x,
    y: height - pose.y,
    turn: clockwise(pose.heading),
    shapes: [inside],
  }
}

/** The ground under everything, in cm, y down: its colour. */
export const drawGround = ({ size, floor }: World): readonly Command[] => [
  { kind: 'rect', x: 0, y: 0, ...size, fill: 'colour' in floor ? floor.colour : '#FFFFFF' },
]

/**
 * What lies on the ground and does not move, in cm, y down: areas, lines and the wooden frame; dots where it has no picture.
 * @param scale px per cm: the frame is as wide in px whatever the scale
 */
export function drawFloor(
  { size, areas, lines }: World,
  scale: number,
  pictured: boolean,
): readonly Command[] {
  const px = 1 / scale
  const edge = (out: number, thickness: number, stroke: string): Command => ({
    kind: 'rect',
    x: -out * px,
    y: -out * px,
    width: size.width + 2 * out * px,
    height: size.height + 2 * out * px,
    round: out * px,
    stroke,
    lineWidth: thickness * px,
  })
  const dots = pictured
    ? []
    : Array.from({ length: Math.floor(size.width / grid) }, (_, column) =>
        Array.from({ length: Math.floor(size.height / grid) }, (_, row): Command => ({
          kind: 'circle',
          x: (column + 0.5) * grid,
          y: (row + 0.5) * grid,
          r: 1.4 * px,
          fill: '#DCC7A5',
        })),
      ).flat()
  return [
    ...dots,
    ...areas.map((one) => areaOf(one, size.height)),
    ...lines.map(({ points, colour, width }): Command => ({
      kind: 'line',
      points: points.map(({ x, y }) => ({ x, y: size.height - y })),
      stroke: colour,
      lineWidth: width,
    })),
    edge(frameWidth / 2, frameWidth - 3, wood),
    edge(1, 2, line),
    edge(frameWidth - 1, 2, line),
  ]
}

/**
 * The numbers of a map's stations, over the way that was drawn from it, in cm, y down.
 * @param stations their middles by number, in cm, y up
 * @param scale px per cm: they can be read from however far away
 */
export function drawStations(stations: readonly Point[], height: number, scale: number): readonly Command[] {
  const px = 1 / scale
  const radius = Math.max(5.5, 11 * px)
  return stations.map(({ x, y }, number): Command => ({
    kind: 'group',
    x,
    y: height - y,
    shapes: [
      { kind: 'circle', x: 0, y: 0, r: radius, fill: '#1F7A45', stroke: line, lineWidth: 2 * px },
      { kind: 'circle', x: 0, y: 0, r: radius - 2.5 * px, stroke: '#FFFFFF', lineWidth: px },
      {
        ...{ kind: 'text', text: String(number), x: 0, y: radius * 0.4, size: radius * 1.15, font: 'title' },
        ...{ align: 'middle', fill: '#FFFFFF' },
      },
    ],
  }))
}
