import type { Course, LaneKind } from '@botgarten/experiments/brain-race'
import type { Effort } from '@botgarten/programs'
import * as v from 'valibot'

/** Where a lane's brain of the course lies: a file beside it, or a program of a card. */
type RacerAt = ({ readonly file: string } | { readonly card: string; readonly file: string }) & {
  /** What is known of how it came about: `npm run efforts`. */
  readonly effort?: Partial<Effort>
}

/** A course as its file says it. */
export interface CourseFile extends Course {
  readonly racers: { readonly [kind in LaneKind]?: RacerAt }
}

const id = v.pipe(v.string(), v.regex(/^[a-z][a-z0-9-]*$/))
const cm = v.pipe(v.number(), v.minValue(0), v.maxValue(10_000))
const pose = v.strictObject({ x: cm, y: cm, heading: v.pipe(v.number(), v.minValue(0), v.maxValue(360)) })
const place = v.strictObject({ x: cm, y: cm })

const measure = v.variant('kind', [
  v.strictObject({ kind: v.literal('way') }),
  v.strictObject({ kind: v.literal('laps'), gates: v.pipe(v.array(place), v.minLength(2)), cm }),
  v.strictObject({ kind: v.literal('time'), obstacle: id, cm }),
])

const whole = v.pipe(v.number(), v.integer(), v.minValue(0))
const effort = v.exactOptional(
  v.strictObject({
    knobs: v.exactOptional(whole),
    bumps: v.exactOptional(whole),
    computer: v.exactOptional(v.pipe(v.number(), v.minValue(0))),
  }),
)
const racer = v.exactOptional(
  v.union([v.strictObject({ file: id, effort }), v.strictObject({ card: id, file: v.string(), effort })]),
)

const course: v.GenericSchema<unknown, CourseFile> = v.pipe(
  v.strictObject({
    ...{ id, world: id, measure },
    starts: v.pipe(v.array(pose), v.minLength(2), v.maxLength(12)),
    shown: v.pipe(v.number(), v.integer(), v.minValue(1)),
    seconds: v.pipe(v.number(), v.integer(), v.minValue(1), v.maxValue(600)),
    racers: v.strictObject({ hand: racer, examples: racer, trying: racer, ifThen: racer }),
  }),
  v.check(({ starts, shown }) => shown < starts.length, 'Some starts are sealed.'),
)

/** @throws {v.ValiError} for what is no course */
export const readCourse = (file: unknown): CourseFile => v.parse(course, file)
