import { kinds, type Check } from '@botgarten/lab'
import * as v from 'valibot'
import type { Card, Playground } from './cardTypes.ts'

const pose = v.strictObject({ x: v.number(), y: v.number(), heading: v.number() })

const check: v.GenericSchema<unknown, Check> = v.pipe(
  v.strictObject({
    id: v.string(),
    kind: v.picklist(Object.keys(kinds)),
    numbers: v.record(v.string(), v.union([v.number(), v.string()])),
    seconds: v.pipe(v.number(), v.minValue(0)),
  }),
  v.check(
    ({ kind, numbers }) => kinds[kind]!.needs.every((name) => Object.hasOwn(numbers, name)),
    'A number that this kind of check needs is missing.',
  ),
)

const neurons = v.pipe(
  v.array(v.strictObject({ type: v.string(), fields: v.record(v.string(), v.string()) })),
  v.minLength(1),
)

const playground = v.picklist(['network', 'drive', 'q-learning', 'sorting'])

const card = v.strictObject({
  id: v.pipe(v.string(), v.regex(/^[a-z][a-z0-9-]*$/)),
  code: v.string(),
  playground,
  group: v.exactOptional(v.picklist(['repair'])),
  chapter: v.exactOptional(v.picklist(['examples', 'trying'])),
  opens: v.exactOptional(v.picklist(['show', 'practise'])),
  grades: v.tuple([v.number(), v.number()]),
  minutes: v.number(),
  starts: v.pipe(v.array(pose), v.minLength(1)),
  needs: v.array(
    v.picklist([
      'distanceSensors',
      'colourSensor',
      'motors',
      'lamp',
      'blueSquare',
      'wall',
      'flag',
      'speaker',
      'display',
    ]),
  ),
  world: v.string(),
  checks: v.pipe(v.array(check), v.minLength(1)),
  next: v.nullable(v.string()),
  hintSteps: v.exactOptional(v.array(v.nullable(v.record(v.string(), v.number())))),
  /** Where the last card of a bed leads. */
  place: v.exactOptional(v.literal('zoo')),
  network: v.exactOptional(
    v.strictObject({ inputs: neurons, outputs: neurons, below: v.exactOptional(v.string()) }),
  ),
  beside: v.exactOptional(
    v.strictObject({
      card: v.string(),
      pose,
      weights: v.record(v.string(), v.record(v.string(), v.record(v.string(), v.number()))),
    }),
  ),
})

/** A folder of cards is called like a playground. @throws ValiError for another name */
export const readBed = (folder: string): Playground => v.parse(playground, folder)

/** Reads `card.json`. @throws ValiError that names the place where the file is wrong. */
export const readCard = (json: unknown): Card => v.parse(card, json)
