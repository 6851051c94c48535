import * as v from 'valibot'
import { bands } from './atoms.ts'
import { shuffled } from './shuffle.ts'
import type { PaperCounts } from './tally.ts'
import { fewest, type Answer, type Chance } from './types.ts'

/** Of a whole school over years. */
const mostAnswers = 5000
const mostLetters = 500

/** The birds that a code may begin with. */
export const birds = [
  ...['blackbird', 'robin', 'blue-tit', 'sparrow', 'greenfinch', 'swallow', 'woodpecker', 'pigeon'],
  ...['magpie', 'bullfinch', 'kingfisher', 'wren', 'nuthatch', 'starling', 'goldfinch', 'stork'],
  ...['owl', 'duck', 'swan', 'crane', 'jay', 'cuckoo', 'heron', 'oriole'],
] as const
export type Bird = (typeof birds)[number]

const id = v.pipe(v.string(), v.regex(/^[0-9a-f]{32}$/))
const name = v.pipe(v.string(), v.regex(/^[a-z][a-z0-9-]{0,39}$/))
const code = v.pipe(
  v.string(),
  v.regex(/^[a-z-]+-[1-9]\d\d$/),
  v.check((text) => birds.includes(text.slice(0, -4) as Bird), 'There is no such bird.'),
)

const answer: v.GenericSchema<unknown, Answer> = v.strictObject({
  id,
  form: name,
  grade: v.pipe(v.number(), v.integer(), v.minValue(3), v.maxValue(12)),
  code: v.nullable(code),
  day: v.pipe(v.string(), v.isoDate()),
  values: v.record(name, v.pipe(v.string(), v.minLength(1), v.maxLength(mostLetters))),
})

const file = v.strictObject({
  botgarten: v.literal('answers'),
  version: v.literal(1),
  answers: v.pipe(v.array(answer), v.maxLength(mostAnswers)),
})

const count = v.pipe(v.number(), v.integer(), v.minValue(0), v.maxValue(1000))
const sentences = v.pipe(v.array(v.pipe(v.string(), v.maxLength(mostLetters))), v.maxLength(300))

const paper: v.GenericSchema<unknown, PaperCounts> = v.strictObject({
  form: name,
  bands: v.pipe(v.array(v.picklist(bands)), v.minLength(1), v.maxLength(bands.length)),
  n: v.pipe(count, v.minValue(fewest)),
  counts: v.record(name, v.pipe(v.array(count), v.maxLength(6))),
  open: v.record(name, sentences),
})

/** Reads counts from paper. @throws ValiError where they are none, or of fewer than five sheets */
export const readPaper = (json: unknown): PaperCounts => v.parse(paper, json)

/** Reads one answer. @throws ValiError where it is none */
export const readAnswer = (json: unknown): Answer => v.parse(answer, json)

/** Reads a file of answers; what stands there twice is one. @throws ValiError that names the place where it is wrong */
export const readAnswersFile = (json: unknown): readonly Answer[] => merged([], v.parse(file, json).answers)

/** The file of answers, in random order. */
export const writeAnswersFile = (answers: readonly Answer[], chance: Chance): string =>
  JSON.stringify({ botgarten: 'answers', version: 1, answers: shuffled(answers, chance) })

/** All answers once. */
export const merged = (some: readonly Answer[], more: readonly Answer[]): readonly Answer[] => [
  ...new Map([...some, ...more].map((one) => [one.id, one])).values(),
]
