import * as v from 'valibot'
import type { Item, ItemKind } from './itemTypes.ts'
import { claims, plan } from './plan.ts'

/** What kinds of items there are: each has its folder under `content/materials`. */
const itemKinds: readonly ItemKind[] = [
  'curriculum',
  'plan',
  'slides',
  'card',
  'observation',
  'sheet',
  'kit',
  'worksheet',
  'observer',
  'checklist',
  'solution',
  'links',
]

/** `3.1` (with levels `3.1b`), `E7.2`, `P 3`, `K 5`, `A NN`, `NN 0`. */
const code = v.pipe(
  v.string(),
  v.regex(/^(([EL])?\d+\.\d|[A-Z]{1,4} [A-Z]{1,2}|[A-Z]{1,4} ([EL] )?\d+|[A-Z]{1,2})$/),
)

const sides = v.pipe(v.number(), v.integer(), v.minValue(1))

const grade = v.pipe(v.number(), v.integer(), v.minValue(1), v.maxValue(13))

const grades = v.pipe(
  v.tuple([grade, grade]),
  v.check(([from, to]) => from <= to, 'The youngest grade comes first.'),
)

const harder = v.strictObject({ upTo: v.number(), reason: v.pipe(v.string(), v.minLength(20)) })

const item: v.GenericSchema<unknown, Item> = v.strictObject({
  id: v.pipe(v.string(), v.regex(/^[a-z][a-z0-9-]*$/)),
  kind: v.picklist(itemKinds),
  code: v.exactOptional(code),
  audience: v.picklist(['pupils', 'teachers']),
  grades,
  minutes: v.pipe(v.number(), v.minValue(1)),
  way: v.picklist(['supervised', 'unsupervised', 'reinforcement', 'all']),
  social: v.picklist(['alone', 'pairs', 'groups', 'class']),
  module: v.pipe(v.number(), v.integer(), v.minValue(0), v.maxValue(4)),
  paper: v.picklist(['a4', 'a5', '16:9']),
  sides: v.exactOptional(v.union([sides, v.record(v.string(), sides)])),
  competences: v.pipe(v.array(v.string()), v.minLength(1)),
  unplugged: v.boolean(),
  levels: v.exactOptional(v.strictObject({ a: v.exactOptional(grades), c: v.exactOptional(grades) })),
  harder: v.exactOptional(v.record(v.string(), harder)),
  claims: v.exactOptional(claims),
  plan: v.exactOptional(plan),
})

/** Reads `item.json`. @throws ValiError that names the place where the file is wrong. */
export const readItem = (json: unknown): Item => v.parse(item, json)
