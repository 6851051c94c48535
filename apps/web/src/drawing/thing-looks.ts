import type { Obstacle } from '@botgarten/simulation'
import { mix } from './colours.ts'
import type { Command, Ink } from './commands.ts'
import type { Size } from './points.ts'
import { brickJoints, triangleCorners, type Outline } from './things.ts'

const line: Ink = { stroke: '#4A3428', lineWidth: 1.2 }
const path = (d: string, ink: Ink): Command => ({ kind: 'path', d, ...ink })
const box = (width: number, height: number, round: number, ink: Ink): Command => ({
  ...{ kind: 'rect', x: width / -2, y: height / -2, width, height, round },
  ...ink,
})

const sizeOf = (shape: Outline): Size =>
  shape.kind === 'circle' ? { width: shape.radius * 2, height: shape.radius * 2 } : shape

function outline(shape: Obstacle['shape'], ink: Ink): Command {
  if (shape.kind === 'circle') return { kind: 'circle', x: 0, y: 0, r: shape.radius, ...ink }
  const { width, height } = shape
  if (shape.kind === 'rectangle') return box(width, height, Math.min(3, width / 8, height / 8), ink)
  return { kind: 'line', points: triangleCorners(width, height, shape.tip), closed: true, ...ink }
}

/** A drawing made for one size, stretched to another. */
const stretched = (own: Size, { width, height }: Size, shapes: readonly Command[]): readonly Command[] => [
  { kind: 'group', scale: [width / own.width, height / own.height], shapes },
]

function crate(size: Size): readonly Command[] {
  const thin = { ...line, lineWidth: 1 }
  const bar = { kind: 'rect', y: -15, width: 5, height: 30, fill: '#C9986A', ...thin } as const
  const nails = [-12.5, 12.5].flatMap((x) =>
    [-11, 11].map((y): Command => ({ kind: 'circle', x, y, r: 0.7, fill: '#4A3428' })),
  )
  return stretched({ width: 30, height: 30 }, size, [
    box(30, 30, 1.5, { fill: '#DDB27C', ...thin }),
    path('M-15-7.5H15M-15 0H15M-15 7.5H15', { stroke: '#A97C48', lineWidth: 0.8 }),
    { ...bar, x: -15 },
    { ...bar, x: 10 },
    box(30, 30, 1.5, thin),
    ...nails,
  ])
}

function rock(size: Size): readonly Command[] {
  const thin = { ...line, lineWidth: 1 }
  return stretched({ width: 29, height: 24 }, size, [
    path('M-14 2C-15-7-6-12 2-11C11-11 16-4 14 4C12 11 3 12-5 11C-11 10-14 8-14 2Z', {
      fill: '#B9AEA3',
      ...thin,
    }),
    path('M14 4C12 11 3 12-5 11C4 9 10 3 9-9C13-6 15-1 14 4Z', { fill: '#978A7E' }),
    path('M-8-4Q-5-8 0-8', { stroke: '#E4DDD4', lineWidth: 1.4 }),
  ])
}

function tree(size: Size): readonly Command[] {
  return stretched({ width: 35, height: 37 }, size, [
    path(
      'M-14-8C-16-16-8-20-3-17C2-22 12-19 12-12C19-10 20-1 15 3C18 11 9 18 3 14C-2 20-13 17-12 9C-20 8-20-4-14-8Z',
      {
        fill: '#8CC063',
        ...line,
        lineWidth: 1,
      },
    ),
    path('M15 3C18 11 9 18 3 14C-2 20-13 17-12 9C0 12 8 4 6-8C10-8 13-4 15 3Z', {
      fill: '#6FA549',
      opacity: 0.8,
    }),
    path('M-7-9q3-3 6-1M3 3q3-2 5 1M-8 4q3 2 6 0', { ...line, lineWidth: 0.9, opacity: 0.7 }),
  ])
}

const wall = ({ width, height }: Size): readonly Command[] => [
  box(width, height, 1.5, { fill: '#D98A63', ...line }),
  path(brickJoints(width, height), { stroke: '#A95F3F', lineWidth: 0.8 }),
  box(width, height, 1.5, line),
]

function ball({ width }: Size): readonly Command[] {
  const thin = { ...line, lineWidth: 0.9 }
  return stretched({ width: 13, height: 13 }, { width, height: width }, [
    { kind: 'circle', x: 0, y: 0, r: 6.5, fill: '#F6F1E6', ...thin },
    path('M-6.1-2.2A6.5 6.5 0 0 1 6.1-2.2C2-4.2-2-4.2-6.1-2.2Z', { fill: '#E4604A', ...thin }),
    path('M-6.1 2.2A6.5 6.5 0 0 0 6.1 2.2C2 4.2-2 4.2-6.1 2.2Z', { fill: '#2F9C95', ...thin }),
    path('M-3-4.2q1.6-1.2 3.2-1.3', { stroke: '#fff', lineWidth: 0.9 }),
  ])
}

/** A plain shape; a rectangle shines a little inside its edge. */
function plain({ shape, colour }: Obstacle): readonly Command[] {
  const whole = outline(shape, { fill: colour, ...line })
  if (shape.kind !== 'rectangle') return [whole]
  const { width, height } = shape
  const inset = Math.min(6, width / 5, height / 5)
  const shine = `M${inset - width / 2} ${height * 0.14}V${inset - height / 2}H${width * 0.1}`
  return [whole, path(shine, { stroke: mix(colour, '#BFE0F7', 0.5), lineWidth: inset / 2 })]
}

const looks = new Map<string | undefined, (size: Size) => readonly Command[]>([
  ['crate', crate],
  ['rock', rock],
  ['tree', tree],
  ['wall', wall],
  ['ball', ball],
])

/** An obstacle about its middle, in cm, y down, light from the upper left. */
export function drawThing(thing: Obstacle): readonly Command[] {
  const look = looks.get(thing.look)
  return look ? look(sizeOf(thing.shape)) : plain(thing)
}

/** Its shadow about the same middle. */
export const drawShadow = ({ shape }: Obstacle): readonly Command[] => [outline(shape, { fill: '#3A2A20' })]
