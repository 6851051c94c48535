import * as v from 'valibot'
import { triangleOf, type Area, type Obstacle, type Pose } from '@botgarten/simulation'
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
type Thing = v.InferOutput<typeof thing>
type Placed = Pick<Area, 'shape' | 'pose'>

const file = v.object({
  robotPoses: v.array(v.union([v.pipe(v.array(place), v.minLength(1)), place])),
  obstacles: v.array(thing),
  colorAreas: v.array(thing),
})

export const looksForeign = (data: unknown): boolean =>
  typeof data === 'object' && data !== null && 'robotPoses' in data

/** The same as data of a scene file of ours; that is to be looked through again. @throws {ProjectError} */
export function readForeignScene(data: unknown): object {
  const result = v.safeParse(file, data, { abortEarly: true })
  if (!result.success) throw new ProjectError('notAScene', result.issues[0].message)
  const { robotPoses, obstacles, colorAreas } = result.output
  return {
    botgartenScene: 1,
    size: { width: tenth(SIZE.width), height: tenth(SIZE.height) },
    floor: { colour: '#FFFFFF' },
    areas: colorAreas.map((one, index): Area => ({
      id: `area${index + 1}`,
      ...placed(one),
      colour: one.color,
    })),
    lines: [],
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
