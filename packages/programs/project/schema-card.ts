import type { World } from '@botgarten/simulation'
import * as v from 'valibot'
import {
  cardColours,
  cardLamps,
  cardLanguages,
  families,
  lackOf,
  languagesOf,
  looksLikeTag,
  mostOfCard as most,
  ownKinds,
  type Asked,
  type OwnCard,
  type OwnCheck,
} from '../own-card.ts'
import { idSchema, programSchema, recordOf } from './schema-program.ts'
import { brainSchema } from './schema-brain.ts'
import { poseSchema } from './schema-world.ts'

// What a schema refuses here is said to children, by the name of the problem.

const problems = {
  cardTags: 'A card holds plain text, and no tags.',
  cardCheck: 'This version knows no such check.',
  cardNumbers: 'A check of the card asks for something that cannot be.',
  cardWords: 'Words of the card are missing.',
} as const
export type CardProblem = keyof typeof problems

export const messageOf = (problem: CardProblem): string => problems[problem]

/** What is wrong with a card, of a message of its schema; undefined for every other message. */
export const problemOf = (message: string): CardProblem | undefined =>
  (Object.keys(problems) as CardProblem[]).find((problem) => problems[problem] === message)

const text = (longest: number) =>
  v.pipe(
    v.string(messageOf('cardWords')),
    v.maxLength(longest),
    v.check((words) => !looksLikeTag(words), messageOf('cardTags')),
  )
const hint = text(most.hint)
const words = v.object({
  ...{ title: text(most.title), story: text(most.story), task: text(most.task) },
  hints: v.tuple([hint, hint, hint]),
})

/** A world is at most so wide, in cm. */
const widest = 10_000

const whole = (least: number, highest: number) =>
  v.pipe(v.number(), v.integer(), v.minValue(least), v.maxValue(highest))

const check: v.GenericSchema<unknown, OwnCheck> = v.pipe(
  v.object({
    id: v.pipe(v.string(), v.regex(/^[a-zA-Z][a-zA-Z0-9]{0,20}$/)),
    kind: v.string(),
    numbers: v.record(idSchema, v.union([v.number(), v.pipe(v.string(), v.maxLength(400))])),
    seconds: v.pipe(v.number(), v.minValue(0), v.maxValue(most.seconds, messageOf('cardNumbers'))),
  }),
  v.check(({ kind }) => Object.hasOwn(ownKinds, kind), messageOf('cardCheck')),
  v.check(({ kind, numbers }) => {
    const asked = Object.hasOwn(ownKinds, kind) ? Object.entries(ownKinds[kind]!.asks) : []
    return (
      asked.length === Object.keys(numbers).length &&
      asked.every(([name, what]) => Object.hasOwn(numbers, name) && couldBe(what, numbers[name]!))
    )
  }, messageOf('cardNumbers')),
)

const program = v.object({ programs: recordOf(programSchema), brains: recordOf(brainSchema) })

export const cardSchema: v.GenericSchema<unknown, OwnCard> = v.pipe(
  v.object({
    text: v.object({ de: v.exactOptional(words), en: v.exactOptional(words) }),
    starts: v.pipe(v.array(poseSchema), v.minLength(1), v.maxLength(most.starts)),
    checks: v.pipe(v.array(check), v.maxLength(most.checks)),
    grades: v.pipe(
      v.tuple([whole(1, most.grade), whole(1, most.grade)]),
      v.check(([from, to]) => from <= to, messageOf('cardNumbers')),
    ),
    minutes: whole(1, most.minutes),
    blocks: v.object({
      level: v.picklist(['plain', 'all']),
      families: v.exactOptional(v.pipe(v.array(v.picklist(families)), v.maxLength(families.length))),
    }),
    draft: v.exactOptional(v.literal(true)),
    start: v.exactOptional(program),
    solution: v.exactOptional(program),
    wrong: v.exactOptional(
      v.pipe(v.array(v.object({ name: text(most.name), ...program.entries })), v.maxLength(most.wrong)),
    ),
  }),
  v.check(
    ({ checks }) => new Set(checks.map(({ id }) => id)).size === checks.length,
    'Two checks have the same id.',
  ),
  v.check((card) => card.draft === true || lackOf(card) === null, messageOf('cardWords')),
  // A language that is begun is whole, once children read it.
  v.check(
    (card) =>
      card.draft === true || cardLanguages.every((one) => !card.text[one] || languagesOf(card).includes(one)),
    messageOf('cardWords'),
  ),
)

/** May a check ask this in some world? */
function couldBe(asked: Asked, value: number | string): boolean {
  if (typeof asked !== 'string') return typeof value === 'number' && value >= asked[0] && value <= asked[1]
  if (asked === 'x' || asked === 'y') return typeof value === 'number' && value >= 0 && value <= widest
  if (typeof value !== 'string') return false
  if (asked === 'lamp') return cardLamps.some((lamp) => lamp === value)
  if (asked === 'points') return arePoints(value)
  if (asked === 'thing' || asked === 'check') return v.is(idSchema, value)
  const colours = asked === 'colours' ? value.split(',') : [value]
  return colours.every((colour) => cardColours.some((one) => one === colour))
}

/** And in this one, among these other checks? */
function canAsk(asked: Asked, value: number | string, world: World, others: readonly string[]): boolean {
  if (asked === 'x') return Number(value) <= world.size.width
  if (asked === 'y') return Number(value) <= world.size.height
  if (asked === 'thing') return world.obstacles.some(({ id }) => id === value)
  if (asked === 'check') return value === '' || others.includes(String(value))
  return asked !== 'points' || pointsIn(String(value)).every((one) => inside(one, world))
}

const point = /^\d{1,5}(\.\d)? \d{1,5}(\.\d)?$/

function arePoints(value: string): boolean {
  const points = value.split(',').map((one) => one.trim())
  return points.length <= most.points && points.every((one) => point.test(one))
}

/** Places of a text like "70 40, 190 40". */
export const pointsIn = (text: string): readonly { readonly x: number; readonly y: number }[] =>
  text.split(',').map((one) => {
    const [x = 0, y = 0] = one.trim().split(' ').map(Number)
    return { x, y }
  })

const inside = ({ x, y }: { readonly x: number; readonly y: number }, { size }: World) =>
  x >= 0 && x <= size.width && y >= 0 && y <= size.height

/** Do its checks ask for what is there, and do its places lie in the world? */
export function fitsWorld(card: OwnCard, world: World): boolean {
  const fits = ({ id, kind, numbers }: OwnCheck) => {
    const others = card.checks.flatMap((other) => (other.id === id ? [] : other.id))
    return Object.entries(ownKinds[kind]!.asks).every(([name, asked]) =>
      canAsk(asked, numbers[name]!, world, others),
    )
  }
  return card.checks.every(fits) && card.starts.every((start) => inside(start, world))
}

/** Has every robot its program, in everything that the card brings? */
export function bringsPrograms({ start, solution, wrong = [] }: OwnCard, world: World): boolean {
  const all = [start, solution, ...wrong].filter((one) => one !== undefined)
  return all.every(({ programs }) => world.robots.every(({ program }) => Object.hasOwn(programs, program)))
}
