import * as v from 'valibot'
import type { World } from '@botgarten/simulation'
import { finite, idSchema } from './schema-program.ts'

/** A world fits into a gymnasium: 100 m. */
const longest = 10_000
const cm = v.pipe(finite, v.minValue(-longest), v.maxValue(longest))
const length = v.pipe(finite, v.gtValue(0), v.maxValue(longest))
const colour = v.pipe(v.string(), v.regex(/^#[0-9A-Fa-f]{6}$/), v.toUpperCase())
const pose = v.object({ x: cm, y: cm, heading: finite })

const shape = v.variant('kind', [
  v.object({ kind: v.literal('rectangle'), width: length, height: length }),
  v.object({ kind: v.literal('triangle'), width: length, height: length }),
  v.object({ kind: v.literal('circle'), radius: length }),
])

/** A picture of the project, or one that ships with the product: no way out of its folder. */
const asset = v.pipe(v.string(), v.regex(/^([0-9a-f]{64}|content:[\w-]+(\/[\w.-]+)*)$/), v.excludes('..'))

const motorPort = v.picklist(['A', 'B', 'C', 'D'])
const sensor = v.object({ kind: v.picklist(['ultrasonic', 'colour']), x: cm, y: cm, angle: finite })

const config = v.object({
  wheelDiameter: length,
  trackWidth: length,
  sensors: v.object({
    1: v.exactOptional(sensor),
    2: v.exactOptional(sensor),
    3: v.exactOptional(sensor),
    4: v.exactOptional(sensor),
  }),
  drive: v.object({ left: motorPort, right: motorPort }),
  noise: v.exactOptional(v.pipe(finite, v.minValue(0), v.maxValue(100))),
})

const robot = v.object({ id: idSchema, pose, program: idSchema, brain: idSchema, config })

const obstacle = v.object({
  id: idSchema,
  shape,
  pose,
  fixed: v.boolean(),
  colour,
  look: v.exactOptional(idSchema),
})

const area = v.object({ id: idSchema, shape, pose, colour })
const line = v.object({
  id: idSchema,
  // y first: engines share one layout among all {x, y} literals, and an object in x makes the physics library's vectors
  // several times slower.
  points: v.array(v.object({ y: cm, x: cm })),
  width: length,
  colour,
})

/** Things in a world are found by their id. */
const idsUnique = ({ robots, obstacles, areas, lines }: World) => {
  const ids = [...robots, ...obstacles, ...areas, ...lines].map(({ id }) => id)
  return new Set(ids).size === ids.length
}

export const worldSchema: v.GenericSchema<unknown, World> = v.pipe(
  v.object({
    size: v.object({ width: length, height: length }),
    floor: v.union([v.object({ asset }), v.object({ colour })]),
    areas: v.array(area),
    lines: v.array(line),
    obstacles: v.array(obstacle),
    robots: v.pipe(v.array(robot), v.minLength(1, 'A world needs a robot.')),
  }),
  v.check((world) => idsUnique(world), 'Two things have the same id.'),
)
