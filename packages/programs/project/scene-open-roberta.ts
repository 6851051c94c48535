import * as v from 'valibot'
import { triangleOf, type Area, type Line, type Obstacle, type Pose } from '@botgarten/simulation'
import { ProjectError } from './error.ts'
import { finite } from './schema-program.ts'

/**
 * Scene files of the Open Roberta simulation (read in its public code): places and lengths are shares of its picture of
 * 750 × 480 px with a border of 10 px, y down, 3 px a cm; a circle's radius is divided by both sides. A robot's start is
 * the second of its two poses.
 */
const PICTURE = { width: 750, height: 480, border: 10, pxPerCm: 3 }
const SIZE = {
  width: (PICTURE.width - 2 * PICTURE.border) / PICTURE.pxPerCm,
  height: (PICTURE.height - 2 * PICTURE.border) / PICTURE.pxPerCm,
}

const share = v.pipe(finite, v.minValue(-10), v.maxValue(10))
const place = v.object({ y: share, x: share, theta: finite })
const colour = v.pipe(
  v.string(),
  v.regex(/^#([0-9A-Fa-f]{3}|[0-9A-Fa-f]{6})$/),
  v.transform((hex) => (hex.length === 4 ? hex.replace(/[^#]/g, '$&$&') : hex).toUpperCase()),
)
const form = <Name extends string>(name: Name) =>
  v.pipe(v.string(), v.toLowerCase(), v.literal(name as Lowercase<Name>))
const thing = v.union([
  v.object({ form: form('rectangle'), x: share, y: share, w: share, h: share, color: colour }),
  v.object({ form: form('circle'), x: share, y: share, r: share, color: colour }),
  v.object({
    ...{ form: form('triangle'), color: colour },
    ...{ ax: share, ay: share, bx: share, by: share, cx: share, cy: share },
  }),
])
/** A square on the floor with a number, which Open Roberta's cameras look for. It says nothing of its size but 36 px. */
const marker = v.object({ x: share, y: share, w: share, h: share, markerId: v.number() })
type Marker = v.InferOutput<typeof marker>
type Thing = v.InferOutput<typeof thing>
type Placed = Pick<Area, 'shape' | 'pose'>

const file = v.object({
  robotPoses: v.array(v.union([v.pipe(v.array(place), v.minLength(1)), place])),
  obstacles: v.array(thing),
  colorAreas: v.array(thing),
  marker: v.optional(v.array(marker), []),
})

export const looksForeign = (data: unknown): boolean =>
  typeof data === 'object' && data !== null && 'robotPoses' in data

/** The same as data of a scene file of ours; that is to be looked through again. @throws {ProjectError} */
export function readForeignScene(data: unknown): object {
  const result = v.safeParse(file, data, { abortEarly: true })
  if (!result.success) throw new ProjectError('notAScene', result.issues[0].message)
  const { robotPoses, obstacles, colorAreas, marker } = result.output
  return {
    botgartenScene: 1,
    size: { width: tenth(SIZE.width), height: tenth(SIZE.height) },
    floor: { colour: '#FFFFFF' },
    areas: [
      ...colorAreas.map((one, index): Area => ({
        id: `area${index + 1}`,
        ...placed(one),
        colour: one.color,
      })),
      ...marker.map((one, index): Area => ({ id: `marker${index + 1}`, ...sheetOf(one), colour: '#FFFFFF' })),
    ],
    lines: marker.flatMap(digitsOf),
    obstacles: obstacles.map(obstacleOf),
    starts: robotPoses.map((pose) => startOf(Array.isArray(pose) ? (pose[1] ?? pose[0]!) : pose)),
    assets: {},
  }
}

const obstacleOf = (one: Thing, index: number): Obstacle => ({
  ...{ id: `thing${index + 1}`, ...placed(one), fixed: true },
  colour: one.color,
})

const tenth = (value: number) => Math.round(value * 10) / 10
const hundredth = (value: number) => Math.round(value * 100) / 100
const point = (x: number, y: number) => ({
  x: (x * PICTURE.width - PICTURE.border) / PICTURE.pxPerCm,
  y: SIZE.height - (y * PICTURE.height - PICTURE.border) / PICTURE.pxPerCm,
})

function startOf({ x, y, theta }: v.InferOutput<typeof place>): Pose {
  const turned = (((-theta * 180) / Math.PI) % 360) + 360
  return rounded({ ...point(x, y), heading: turned % 360 })
}

const rounded = ({ x, y, heading }: Pose): Pose => ({
  ...{ y: hundredth(y), x: hundredth(x) },
  heading: hundredth(heading),
})

/** Thinner than this is nothing to bump into. */
const atLeast = (cm: number) => Math.max(0.5, hundredth(Math.abs(cm)))

function placed(one: Thing): Placed {
  if (one.form === 'triangle') return triangle(one)
  if (one.form === 'circle') {
    const radius = atLeast((one.r * PICTURE.width * PICTURE.height) / PICTURE.pxPerCm)
    return { shape: { kind: 'circle', radius }, pose: rounded({ ...point(one.x, one.y), heading: 0 }) }
  }
  const width = atLeast((one.w * PICTURE.width) / PICTURE.pxPerCm)
  const height = atLeast((one.h * PICTURE.height) / PICTURE.pxPerCm)
  const middle = point(one.x + one.w / 2, one.y + one.h / 2)
  return { shape: { kind: 'rectangle', width, height }, pose: rounded({ ...middle, heading: 0 }) }
}

function triangle({ ax, ay, bx, by, cx, cy }: Extract<Thing, { form: 'triangle' }>): Placed {
  const found = triangleOf(point(ax, ay), point(bx, by), point(cx, cy))
  if (found?.shape.kind !== 'triangle') throw new ProjectError('notAScene', 'A triangle is only a line.')
  const { width, height, tip } = found.shape
  const shape = {
    kind: 'triangle',
    width: atLeast(width),
    height: atLeast(height),
    tip: hundredth(tip ?? 0),
  } as const
  return { shape, pose: rounded(found.pose) }
}

/** Around the number of a marker is a margin of a twelfth. */
const MARGIN = 1 / 12

function sheetOf({ x, y, w, h }: Marker): Placed {
  const wide = { x: x - w * MARGIN, y: y - h * MARGIN, w: w * (1 + 2 * MARGIN), h: h * (1 + 2 * MARGIN) }
  return placed({ form: 'rectangle', color: '#FFFFFF', ...wide })
}

const signs: { readonly [sign: string]: number } = { '-': -1, '0': 0, '+': 1 }

/** Each digit in one stroke: −1, 0, 1 from left to right and from below to above. */
const strokes = [
  '-- +- ++ -+ --',
  '0- 0+',
  '-+ ++ +0 -0 -- +-',
  '-+ ++ +0 -0 +0 +- --',
  '-+ -0 +0 ++ +-',
  '++ -+ -0 +0 +- --',
  '++ -+ -- +- +0 -0',
  '-+ ++ +-',
  '-0 +0 ++ -+ -- +- +0',
  '+0 -0 -+ ++ +- --',
].map((stroke) => stroke.split(' ').map(([across, up]) => [signs[across!]!, signs[up!]!] as const))

/** The number of a marker as lines on the floor; none for what is no number of at most two digits. */
function digitsOf({ x, y, w, h, markerId }: Marker, index: number): Line[] {
  if (!Number.isInteger(markerId) || markerId < 0 || markerId > 99) return []
  const middle = point(x + w / 2, y + h / 2)
  const size = atLeast((h * PICTURE.height) / PICTURE.pxPerCm)
  const digits = [...String(markerId)].map(Number)
  return digits.map((digit, place) => {
    const left = middle.x + (place - (digits.length - 1) / 2) * size * 0.44
    return {
      id: `marker${index + 1}digit${place + 1}`,
      points: strokes[digit]!.map(([across, up]) => ({
        x: hundredth(left + across * size * 0.14),
        y: hundredth(middle.y + up * size * 0.32),
      })),
      width: Math.max(0.5, hundredth(size * 0.1)),
      colour: '#000000',
    }
  })
}
