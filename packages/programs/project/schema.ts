import * as v from 'valibot'
import { mostOf } from '@botgarten/learning/neural-network/examples/types'
import { laneKinds } from '../lanes.ts'
import type { Learned, Project } from '../types.ts'
import { finite, idSchema, programSchema, recordOf, textSchema } from './schema-program.ts'
import { assetsSchema } from './schema-assets.ts'
import { mapsSchema } from './schema-maps.ts'
import { anyBrain, apart } from './any-brain.ts'
import { cardSchema } from './schema-card.ts'
import { tableSchema } from './schema-tables.ts'
import { withVersion } from './versions.ts'
import { worldSchema } from './schema-world.ts'

const whole = v.pipe(v.number(), v.integer(), v.minValue(0), v.maxValue(1_000_000))
const station = v.pipe(v.number(), v.integer(), v.minValue(0), v.maxValue(9999))
const learnedRun = v.object({
  ...{
    map: textSchema,
    start: station,
    goal: station,
    closed: textSchema,
    way: textSchema,
    guess: textSchema,
  },
  pay: v.exactOptional(textSchema),
  ...{ alpha: finite, gamma: finite, nu: finite, rho: finite, rules: textSchema, seed: whole },
  ...{
    episodes: whole,
    moves: whole,
    limitEpisodes: whole,
    limitMoves: whole,
    shortest: whole,
    found: whole,
  },
})
const learned: v.GenericSchema<Learned> = v.object({
  ...{ seed: whole, moves: whole, key: textSchema },
  noted: v.boolean(),
  runs: v.pipe(v.array(learnedRun), v.maxLength(1000)),
})

const progress = v.object({ starts: v.array(whole), hints: whole })
const seconds = v.pipe(finite, v.minValue(0), v.maxValue(1e8))
const effort = v.object({ knobs: whole, starts: whole, bumps: whole, hand: seconds, computer: seconds })
const lane = v.exactOptional(v.picklist(laneKinds))
const raced = v.object({
  course: idSchema,
  brains: v.pipe(whole, v.maxValue(laneKinds.length)),
  ...{ trust: lane, explain: lane },
})

const madeFrom = v.pipe(v.array(v.object({ id: idSchema, title: textSchema })), v.maxLength(100))

const programsExist = ({ programs, world }: Project) =>
  world.robots.every(({ program }) => Object.hasOwn(programs, program))

const rowsIn = ({ brains }: Project) =>
  Object.values(brains).reduce((sum, { examples }) => sum + (examples?.rows.length ?? 0), 0)

/** What is not named here is left out. Tables lie among the brains, or, in older files, in a part of their own. */
export const projectSchema: v.GenericSchema<unknown, Project> = v.pipe(
  v.object({
    botgarten: v.picklist([1, 2, 3, 4, 5]),
    name: textSchema,
    card: v.exactOptional(idSchema),
    playground: v.exactOptional(v.literal('sorting')),
    programs: recordOf(programSchema),
    world: worldSchema,
    brains: recordOf(anyBrain),
    tables: v.exactOptional(recordOf(tableSchema)),
    maps: v.exactOptional(mapsSchema),
    ownCard: v.exactOptional(cardSchema),
    q: v.exactOptional(recordOf(learned)),
    sorting: v.exactOptional(recordOf(v.unknown())),
    assets: assetsSchema,
    progress: v.exactOptional(progress),
    effort: v.exactOptional(effort),
    raced: v.exactOptional(raced),
    shelf: v.exactOptional(v.picklist(['plain', 'all'])),
    madeFrom: v.exactOptional(madeFrom),
  }),
  v.transform((project): Project => withVersion(apart(project))),
  v.check((project) => programsExist(project), 'A robot has a program that is not there.'),
  v.check((project) => rowsIn(project) <= mostOf.projectRows, 'There are too many examples.'),
)
