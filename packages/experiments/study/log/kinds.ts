import type {
  Document,
  DriveKey,
  Hand,
  Recording,
  Remembered,
  StepKind,
  TrainingChange,
} from '@botgarten/lab'
import type { Brain } from '@botgarten/learning/neural-network/brain'
import { parseProject, type Project } from '@botgarten/programs'
import type { Pose, RobotKey } from '@botgarten/simulation'
import * as v from 'valibot'

// What a field of a line may hold. Programs, worlds and brains go through the reader of projects, with all its limits.

/** A name that no program has: the bare robot's own. */
const spare = ' '

const bare: Project = {
  ...{ botgarten: 1, name: '', brains: {}, assets: {} },
  programs: { [spare]: { stacks: [], config: { stacks: [] } } },
  world: {
    ...{
      size: { width: 100, height: 100 },
      floor: { colour: '#FFFFFF' },
      areas: [],
      lines: [],
      obstacles: [],
    },
    robots: [
      {
        ...{ id: 'bo', pose: { x: 50, y: 50, heading: 90 }, program: spare, brain: '' },
        config: { wheelDiameter: 5, trackWidth: 12, sensors: {}, drive: { left: 'C', right: 'B' } },
      },
    ],
  },
}

const parsed = <Part>(make: (data: unknown) => unknown, take: (project: Project) => Part) =>
  v.pipe(
    v.unknown(),
    v.rawTransform<unknown, Part>(({ dataset, addIssue, NEVER }) => {
      try {
        return take(parseProject(make(dataset.value)))
      } catch (error) {
        addIssue({ message: error instanceof Error ? error.message : '' })
        return NEVER
      }
    }),
  )

const isObject = (value: unknown): value is object =>
  typeof value === 'object' && value !== null && !Array.isArray(value)

const documentOf = ({ programs, world, brains, tables }: Project): Document => ({
  ...{ programs, world, brains },
  ...(tables && { tables }),
})
const brain = parsed<Brain>(
  (value) => ({ ...bare, brains: { one: value } }),
  ({ brains }) => brains['one']!,
)

/** Up to a day of milliseconds. */
const whole = v.pipe(v.number(), v.integer(), v.minValue(0), v.maxValue(86_400_000))
const seed = v.pipe(v.number(), v.integer(), v.minValue(0), v.maxValue(4_294_967_295))
const number = v.pipe(v.number(), v.finite(), v.minValue(-1e9), v.maxValue(1e9))
const percent = v.pipe(v.number(), v.minValue(-100), v.maxValue(100))
const reserved = ['__proto__', 'constructor', 'prototype']
const name = v.pipe(
  v.string(),
  v.maxLength(220),
  v.check((text) => !reserved.includes(text), 'This name is reserved.'),
)
const pose = v.strictObject({ x: number, y: number, heading: number })
const others = v.record(name, percent)
const drive = v.strictObject({
  id: name,
  by: v.picklist(['hand', 'keys', 'pad', 'touch', 'coach', 'program', 'file']),
  seed,
})
const robot = v.pipe(v.number(), v.integer(), v.minValue(0), v.maxValue(3))
const key: v.GenericSchema<unknown, DriveKey> = v.picklist(['up', 'down', 'left', 'right'])
const step: v.GenericSchema<unknown, StepKind> = v.picklist(['tick', 'block', 'over', 'network'])
const button: v.GenericSchema<unknown, RobotKey> = v.picklist([
  'enter',
  'up',
  'down',
  'left',
  'right',
  'escape',
])

const hand: v.GenericSchema<unknown, Omit<Hand, 'robot'> | null> = v.nullable(
  v.strictObject({ left: percent, right: percent, others }),
)
const recording: v.GenericSchema<unknown, (Omit<Recording, 'robot'> & { robot: string }) | null> = v.nullable(
  v.strictObject({
    ...{ robot: name, network: name, drive },
    every: v.pipe(v.number(), v.integer(), v.minValue(1), v.maxValue(60)),
  }),
)
const remembered: v.GenericSchema<unknown, Omit<Remembered, 'robot'> & { robot: string }> = v.strictObject({
  ...{ robot: name, network: name, drive, others },
  wheels: v.strictObject({ left: percent, right: percent }),
})
const training = parsed<TrainingChange>(
  (value) => ({
    ...bare,
    brains: {
      one: { kind: 'network', layers: [], weights: {}, sets: {}, ...(isObject(value) && given(value)) },
    },
  }),
  ({ brains }) => {
    const { examples, practice } = brains['one']!
    return { ...(examples && { examples }), ...(practice && { practice }) }
  },
)

/** Null is said by a field of its own: there are none any more. */
const given = (value: object) =>
  Object.fromEntries(Object.entries(value).filter(([name]) => name === 'examples' || name === 'practice'))

/** The reader of each type of field, by the type's name in the code book. */
export const kinds = {
  whole,
  seed,
  number,
  name,
  yes: v.boolean(),
  names: v.pipe(v.array(name), v.maxLength(1000)),
  hash: v.pipe(v.string(), v.regex(/^[0-9a-f]{16}$/)),
  pseudonym: v.pipe(v.string(), v.regex(/^\d{4}[A-Z]$/)),
  pose: pose as v.GenericSchema<unknown, Pose>,
  'pose or nothing': v.nullable(pose) as v.GenericSchema<unknown, Pose | null>,
  poses: v.record(name, pose) as v.GenericSchema<unknown, { readonly [id: string]: Pose }>,
  document: parsed<Document>((value) => {
    const { programs, world, brains, tables } = isObject(value) ? (value as Partial<Document>) : {}
    return { ...bare, programs, world, brains, ...(tables && { tables }) }
  }, documentOf),
  programs: parsed<Document['programs']>(
    (value) => ({ ...bare, programs: isObject(value) ? { ...value, ...bare.programs } : value }),
    ({ programs: { [spare]: _, ...programs } }) => programs,
  ),
  brain,
  training,
  robot,
  key,
  button,
  step,
  hand,
  recording,
  remembered,
}

export type Kind = keyof typeof kinds
