import * as v from 'valibot'
import { orderings } from './orders.ts'

/** Limits of a study. Pseudonyms have two digits for a group and two for a child. */
export const mostOf = { bytes: 200_000, modules: 12, cards: 60, groups: 99, children: 40, title: 80 }

const id = v.pipe(v.string(), v.regex(/^[a-z0-9][a-z0-9-]{0,39}$/))
const title = v.pipe(v.string(), v.trim(), v.minLength(1), v.maxLength(mostOf.title))
const between = (least: number, most: number) =>
  v.pipe(v.number(), v.integer(), v.minValue(least), v.maxValue(most))
const distinct = (names: readonly string[]) => new Set(names).size === names.length

const moduleSchema = v.strictObject({
  id,
  title,
  cards: v.pipe(
    v.array(id),
    v.minLength(1),
    v.maxLength(mostOf.cards),
    v.check((cards) => distinct(cards)),
  ),
})

const schema = v.strictObject({
  botgarten: v.literal('study'),
  version: v.literal(1),
  id,
  title,
  seed: between(0, 4_294_967_295),
  groups: between(1, mostOf.groups),
  children: between(1, mostOf.children),
  modules: v.pipe(
    v.array(moduleSchema),
    v.minLength(1),
    v.maxLength(mostOf.modules),
    v.check((modules) => distinct(modules.map((one) => one.id))),
  ),
  order: v.picklist(orderings),
  level: v.nullable(v.picklist(['plain', 'all'])),
  maps: v.nullable(v.pipe(v.array(id), v.maxLength(60))),
  log: v.boolean(),
  word: v.pipe(v.string(), v.regex(/^[\p{L}\d]{4,20}$/u)),
})

/**
 * What a researcher has planned. `groups` of `children` each. `modules`: their `cards` by id, `free` for the free lab. `level`:
 * which toolbox; null: as the child likes. `maps`: by id, which may be learned on; null: all. `log`: is what happens written down,
 * where the child agrees? `word`: whoever knows it gets to the researcher's page on a device of the study.
 */
export type StudyPlan = v.InferOutput<typeof schema>

/** Why a file is no study: its size, its JSON, or the field that is wrong. */
export class PlanError extends Error {
  readonly field: string
  constructor(field: string) {
    super(`This is not a study: ${field}`)
    this.field = field
  }
}

/** Reads a study's file, or what was kept of one. @throws {PlanError} and nothing else */
export function readPlan(source: unknown): StudyPlan {
  const result = v.safeParse(schema, typeof source === 'string' ? dataIn(source) : source, {
    abortEarly: true,
  })
  if (result.success) return result.output
  const key = result.issues[0].path?.[0]?.key
  throw new PlanError(typeof key === 'string' ? key.slice(0, 40) : 'file')
}

function dataIn(text: string): unknown {
  if (text.length > mostOf.bytes) throw new PlanError('size')
  try {
    return JSON.parse(text)
  } catch {
    throw new PlanError('file')
  }
}

/** The file of a study. @throws {PlanError} where it is none */
export const writePlan = (plan: StudyPlan): string => `${JSON.stringify(readPlan(plan), null, 2)}\n`
