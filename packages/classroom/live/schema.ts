import * as v from 'valibot'

const id = v.pipe(v.string(), v.regex(/^[\w-]{1,64}$/))
const integer = (least: number, most: number) =>
  v.pipe(v.number(), v.integer(), v.minValue(least), v.maxValue(most))
const centimetres = v.pipe(v.number(), v.minValue(-10_000), v.maxValue(10_000))

/** A report of a pupil's page. The trail is at most 2 kB. */
export const here = v.strictObject({
  card: v.nullable(id),
  project: v.nullable(id),
  checks: v.pipe(v.array(v.picklist(['open', 'passed', 'failed'])), v.maxLength(20)),
  failed: integer(0, 999),
  running: v.boolean(),
  idle: integer(0, 86_400),
  size: v.nullable(v.strictTuple([integer(1, 10_000), integer(1, 10_000)])),
  pose: v.nullable(
    v.strictObject({
      x: centimetres,
      y: centimetres,
      heading: v.pipe(v.number(), v.minValue(-100_000), v.maxValue(100_000)),
    }),
  ),
  trail: v.pipe(v.array(integer(-9999, 9999)), v.maxLength(320)),
})

const pupils = v.union([v.literal('all'), v.pipe(v.array(id), v.minLength(1), v.maxLength(100))])

/** A hint of a card by its number, or in the teacher's own words; or a card's own start program. */
export const handout = v.variant('kind', [
  v.strictObject({ to: pupils, kind: v.literal('hint'), card: id, hint: integer(1, 9) }),
  v.strictObject({
    to: pupils,
    kind: v.literal('hint'),
    text: v.pipe(v.string(), v.trim(), v.minLength(1), v.maxLength(500)),
  }),
  v.strictObject({ to: pupils, kind: v.literal('program'), card: id }),
])

export const free = v.strictObject({
  cards: v.nullable(v.pipe(v.array(id), v.maxLength(300))),
  level: v.nullable(v.picklist(['plain', 'all'])),
})
