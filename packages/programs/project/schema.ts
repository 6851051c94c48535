import * as v from 'valibot'
import type { Brain } from '@botgarten/learning/neural-network'
import type { Project } from '../types.ts'
import { finite, idSchema, programSchema, recordOf, textSchema } from './schema-program.ts'
import { worldSchema } from './schema-world.ts'

const weights = recordOf(recordOf(finite))
const neuron = v.object({ id: idSchema, activation: v.literal('identity'), bias: finite })

const brain: v.GenericSchema<Brain> = v.object({
  kind: v.literal('network'),
  layers: v.array(v.array(neuron)),
  weights,
  sets: recordOf(weights),
})

const sha256 = v.pipe(v.string(), v.regex(/^[0-9a-f]{64}$/))
const base64 = v.pipe(v.string(), v.regex(/^[A-Za-z0-9+/]*={0,2}$/))
const asset = v.object({ type: v.literal('image/png'), base64 })

const whole = v.pipe(v.number(), v.integer(), v.minValue(0), v.maxValue(1_000_000))
const progress = v.object({ starts: v.array(whole), hints: whole })

const programsExist = ({ programs, world }: Project) =>
  world.robots.every(({ program }) => Object.hasOwn(programs, program))

/** What is not named here is left out. */
export const projectSchema: v.GenericSchema<unknown, Project> = v.pipe(
  v.object({
    botgarten: v.literal(1),
    name: textSchema,
    card: v.exactOptional(idSchema),
    programs: recordOf(programSchema),
    world: worldSchema,
    brains: recordOf(brain),
    assets: v.record(sha256, asset),
    progress: v.exactOptional(progress),
  }),
  v.check((project) => programsExist(project), 'A robot has a program that is not there.'),
)
