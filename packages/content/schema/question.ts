import * as v from 'valibot'
import { readItemText } from './itemText.ts'
import { plainOf } from './markdown.ts'
import type { Question, QuestionRun, QuestionText } from './questionTypes.ts'

const id = v.pipe(v.string(), v.regex(/^[a-z][a-z0-9-]*$/))
const card = { card: id, file: v.pipe(v.string(), v.regex(/^(start|solution|wrong\/[a-z0-9-]+)$/)) }

/** What is run to find an answer. */
export const questionRun: v.GenericSchema<unknown, QuestionRun> = v.variant('observe', [
  v.strictObject({
    observe: v.picklist(['moves', 'meets', 'lamp', 'tone']),
    ...card,
    start: v.pipe(v.number(), v.integer(), v.minValue(0)),
    seconds: v.pipe(v.number(), v.minValue(0.5), v.maxValue(60)),
  }),
  v.strictObject({ observe: v.literal('way'), ...card }),
  v.strictObject({ observe: v.literal('cage'), cage: id, setting: v.number() }),
  v.strictObject({
    observe: v.literal('group'),
    set: id,
    features: v.pipe(v.array(v.string()), v.minLength(1)),
    flags: v.pipe(v.array(id), v.minLength(2)),
    thing: id,
  }),
])

const question: v.GenericSchema<unknown, Question> = v.pipe(
  v.strictObject({
    id,
    module: v.pipe(v.number(), v.integer(), v.minValue(1), v.maxValue(4)),
    grades: v.tuple([v.number(), v.number()]),
    run: questionRun,
    choices: v.pipe(v.array(v.string()), v.minLength(2), v.maxLength(4)),
    answer: v.string(),
  }),
  v.check(({ choices, answer }) => choices.includes(answer), 'The answer is one of the choices.'),
  v.check(({ choices }) => new Set(choices).size === choices.length, 'A choice stands there twice.'),
)

/** Reads `question.json`. @throws ValiError that names the place where the file is wrong. */
export const readQuestion = (json: unknown): Question => v.parse(question, json)

/**
 * Reads a question's words: `# Question?`, then the sections Choices (a list of `outcome: words`) and Why (named so in
 * every language). @throws SyntaxError that names what is missing.
 */
export function readQuestionText(markdown: string): QuestionText {
  const { title, sections } = readItemText(markdown)
  const body = (name: string) => {
    const found = sections.find((section) => section.title === name)
    if (!found?.body.length) throw new SyntaxError(`The section "${name}" is missing.`)
    return found.body
  }
  const [list] = body('Choices')
  if (list?.type !== 'list')
    throw new SyntaxError('The section "Choices" must be a list of "outcome: words".')
  return { question: title, choices: Object.fromEntries(list.children.map(choiceOf)), why: body('Why') }
}

function choiceOf(item: Parameters<typeof plainOf>[0]): [string, string] {
  const [, outcome, words] = /^([a-z0-9-]+): (.+)$/.exec(plainOf(item)) ?? []
  if (!outcome || !words) throw new SyntaxError(`The choice "${plainOf(item)}" must be "outcome: words".`)
  return [outcome, words]
}
