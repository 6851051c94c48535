import * as v from 'valibot'
import { moments, steps, topics, type Form, type FormItem, type FormText } from './formTypes.ts'
import { readItemText } from './itemText.ts'
import { plainOf } from './markdown.ts'

/** A form's items; more than a child answers in a lesson. */
const mostItems = 40
const mostLetters = 400

const id = v.pipe(v.string(), v.regex(/^[a-z][a-z0-9-]{0,39}$/))
const topic = v.picklist(topics)

const item: v.GenericSchema<unknown, FormItem> = v.variant('kind', [
  v.strictObject({ id, kind: v.literal('scale'), scale: id, topic: v.exactOptional(topic) }),
  v.strictObject({
    id,
    kind: v.literal('choice'),
    choices: v.pipe(v.array(id), v.minLength(2), v.maxLength(6)),
  }),
  v.strictObject({ id, kind: v.literal('text') }),
  v.strictObject({ id, kind: v.literal('robot'), question: id, topic }),
])

const isOnce = (names: readonly string[]) => new Set(names).size === names.length

const form: v.GenericSchema<unknown, Form> = v.pipe(
  v.strictObject({
    id,
    moment: v.picklist(moments),
    items: v.pipe(v.array(item), v.minLength(1), v.maxLength(mostItems)),
    screens: v.array(v.pipe(v.array(id), v.minLength(1))),
  }),
  v.check(({ items }) => isOnce(items.map((one) => one.id)), 'Two items have the same name.'),
  v.check(
    ({ items }) => items.every((one) => one.kind !== 'choice' || isOnce(one.choices)),
    'A choice stands there twice.',
  ),
  v.check(
    ({ items, screens }) => screens.flat().join(' ') === items.map((one) => one.id).join(' '),
    'The screens hold every item once, in the order of the items.',
  ),
)

/** Reads `form.json`. @throws ValiError that names the place where the file is wrong. */
export const readForm = (json: unknown): Form => v.parse(form, json)

/**
 * Reads a form's words: `# Title`, a sentence, then a section for every topic, scale and item: a list of `name: words`.
 * @throws SyntaxError that names what is wrong
 */
export function readFormText(markdown: string): FormText {
  const { title, lead, sections } = readItemText(markdown)
  return {
    title,
    lead: lead.map((node) => plainOf(node)).join(' '),
    words: Object.fromEntries(
      sections.map(({ title: name, body }) => {
        const [list] = body
        if (list?.type !== 'list') throw new SyntaxError(`The section "${name}" must be a list.`)
        return [name, Object.fromEntries(list.children.map((line) => lineOf(plainOf(line))))]
      }),
    ),
  }
}

function lineOf(line: string): readonly [string, string] {
  const [, name, words] = /^([a-z0-9-]+): (.+)$/.exec(line) ?? []
  if (!name || !words) throw new SyntaxError(`"${line}" must be "name: words".`)
  return [name, words]
}

/** The words that a form needs, as `section.name`. */
function neededBy({ items }: Form): readonly string[] {
  const found = items.flatMap((one) => {
    const own = one.kind === 'robot' ? [] : [`${one.id}.question`]
    if (one.kind === 'choice') own.push(...one.choices.map((choice) => `${one.id}.${choice}`))
    if (one.kind === 'scale') own.push(...steps.map((step) => `${one.scale}.${step}`))
    if ('topic' in one) own.push(...['label', 'title', 'reminder'].map((name) => `${one.topic}.${name}`))
    return own
  })
  return [...new Set(found)]
}

/** The words that a text lacks, as `section.name`; none where the form can be shown in its language. */
export const missingIn = (form: Form, { words }: FormText): readonly string[] =>
  neededBy(form).filter((needed) => {
    const [section = '', name = ''] = needed.split('.')
    const there = Object.hasOwn(words, section) ? words[section] : undefined
    return !(there && Object.hasOwn(there, name) && there[name]!.trim() !== '')
  })

const sentence = v.pipe(v.string(), v.maxLength(mostLetters))
const text = v.strictObject({
  title: v.pipe(sentence, v.minLength(1)),
  lead: sentence,
  words: v.record(id, v.record(v.pipe(v.string(), v.regex(/^[a-z0-9][a-z0-9-]{0,39}$/)), sentence)),
})

const ownForm = v.pipe(
  v.strictObject({
    botgarten: v.literal('form'),
    version: v.literal(1),
    form,
    text: v.record(v.pipe(v.string(), v.regex(/^[a-z]{2}(-[A-Za-z]+)?$/)), text),
  }),
  v.check(({ text }) => Object.keys(text).length > 0, 'There are words in one language at least.'),
  v.check(
    ({ form, text }) => Object.values(text).every((one) => missingIn(form, one).length === 0),
    'Words are missing.',
  ),
)

/** A form with its words, by language. */
export interface LoadedForm {
  readonly form: Form
  readonly text: { readonly [language: string]: FormText }
}

/** Reads the file of a form that a teacher has changed. @throws ValiError for what is no such file */
export function readFormFile(json: unknown): LoadedForm {
  const { form, text } = v.parse(ownForm, json)
  return { form, text }
}

/** The file of a form. */
export const writeFormFile = ({ form, text }: LoadedForm): string =>
  JSON.stringify({ botgarten: 'form', version: 1, form, text }, null, 2)
