import * as v from 'valibot'
import type { World } from '@botgarten/simulation'
import { most } from './limits.ts'
import { finite, idSchema } from './schema-program.ts'

/** A world fits into a gymnasium: 100 m. */
const longest = 10_000
const cm = v.pipe(finite, v.minValue(-longest), v.maxValue(longest))
const length = v.pipe(finite, v.gtValue(0), v.maxValue(longest))
const colour = v.pipe(v.string(), v.regex(/^#[0-9A-Fa-f]{6}$/), v.toUpperCase())
export const poseSchema = v.object({ x: cm, y: cm, heading: finite })

const shape = v.variant('kind', [
  v.object({ kind: v.literal('rectangle'), width: length, height: length }),
  v.object({ kind: v.literal('triangle'), width: length, height: length, tip: v.exactOptional(cm) }),
  v.object({ kind: v.literal('circle'), radius: length }),
])

/** A picture of the project, or one that ships with the product: no way out of its folder. */
const asset = v.pipe(v.string(), v.regex(/^([0-9a-f]{64}|content:[\w-]+(\/[\w.-]+)*)$/), v.excludes('..'))

const motorPort = v.picklist(['A', 'B', 'C', 'D'])
const sensorKind = v.picklist([
  'ultrasonic',
  'colour',
  'touch',
  'gyro',
  'infrared',
  'sound',
  'compass',
  'position',
  'irseeker',
])
const sensor = v.object({
  ...{ kind: sensorKind, x: cm, y: cm, angle: finite },
  maker: v.exactOptional(v.literal('hitechnic')),
})
const motor = v.exactOptional(
  v.object({
    kind: v.picklist(['large', 'medium', 'other']),
    reversed: v.exactOptional(v.literal(true)),
    unregulated: v.exactOptional(v.literal(true)),
  }),
)
const strength = v.pipe(finite, v.minValue(0.5), v.maxValue(1))

export const robotConfigSchema = v.object({
  wheelDiameter: length,
  trackWidth: length,
  sensors: v.object({
    1: v.exactOptional(sensor),
    2: v.exactOptional(sensor),
    3: v.exactOptional(sensor),
    4: v.exactOptional(sensor),
  }),
  drive: v.object({ left: motorPort, right: motorPort }),
  motors: v.exactOptional(v.object({ A: motor, B: motor, C: motor, D: motor })),
  noise: v.exactOptional(v.pipe(finite, v.minValue(0), v.maxValue(100))),
  delay: v.exactOptional(v.pipe(finite, v.integer(), v.minValue(0), v.maxValue(60))),
  strength: v.exactOptional(v.object({ left: strength, right: strength })),
})

const robot = v.object({
  id: idSchema,
  pose: poseSchema,
  program: idSchema,
  brain: idSchema,
  config: robotConfigSchema,
})

const obstacle = v.object({
  id: idSchema,
  shape,
  pose: poseSchema,
  fixed: v.boolean(),
  colour,
  look: v.exactOptional(idSchema),
})

const area = v.object({ id: idSchema, shape, pose: poseSchema, colour })
const line = v.object({
  id: idSchema,
  // y first: engines share one layout among all {x, y} literals, and an object in x makes the physics library's vectors
  // several times slower.
  points: v.pipe(v.array(v.object({ y: cm, x: cm })), v.maxLength(most.points)),
  width: length,
  colour,
})

/** Things in a world are found by their id. */
export const idsUnique = ({ robots, obstacles, areas, lines }: Ids) => {
  const ids = [...(robots ?? []), ...obstacles, ...areas, ...lines].map(({ id }) => id)
  return new Set(ids).size === ids.length
}

type Ids = Pick<World, 'obstacles' | 'areas' | 'lines'> & { readonly robots?: World['robots'] }

/** A world without its robots. */
export const sceneEntries = {
  size: v.object({ width: length, height: length }),
  floor: v.union([v.object({ asset }), v.object({ colour })]),
  areas: v.pipe(v.array(area), v.maxLength(most.areas)),
  lines: v.pipe(v.array(line), v.maxLength(most.lines)),
  obstacles: v.pipe(v.array(obstacle), v.maxLength(most.obstacles)),
}

export const worldSchema: v.GenericSchema<unknown, World> = v.pipe(
  v.object({
    ...sceneEntries,
    robots: v.pipe(
      v.array(robot),
      v.minLength(1, 'A world needs a robot.'),
      v.maxLength(most.robots, `A world holds at most ${most.robots} robots.`),
    ),
  }),
  v.check((world) => idsUnique(world), 'Two things have the same id.'),
)
