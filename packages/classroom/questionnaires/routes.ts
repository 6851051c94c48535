import { columnsOf, growthOf, mixed, readPaper, rowsOf, shuffled, talliesOf } from '@botgarten/answers'
import { newFormKey } from '@botgarten/answers/tokens'
import { readFormFile, type LoadedForm } from '@botgarten/content/questionnaires'
import * as v from 'valibot'
import type { AskingRow } from '../database/answers/tables.ts'
import { countPupils } from '../joining/pupils-store.ts'
import type { Ports } from '../ports.ts'
import { Refusal } from '../refusal.ts'
import { route, type Answer, type Call, type Route } from '../route.ts'
import { answersTo, countsOf, settle } from './answers-store.ts'
import { askedIn, gradeIn, inTime, type Asked } from './asked.ts'
import { addAsking, askingOf, askingsOf, openAgain, openAskingOf, setState } from './askings-store.ts'
import { chanceOf } from './chance.ts'
import { addPaper, papersOf, removePaper } from './paper-store.ts'

/** So long after a form was closed what is on its way is still taken, ms. */
const grace = 60_000
const mostBytes = 200_000
/** Fewer than so many are not counted out. */
const fewest = 5

const name = v.pipe(v.string(), v.regex(/^[a-z][a-z0-9-]{0,39}$/))
/** A form of the product by its id, or the file of one that was changed. */
const wanted = v.union([v.strictObject({ form: name }), v.strictObject({ own: v.unknown() })])
type Wanted = v.InferOutput<typeof wanted>
/** Read by the parser of answers. */
const typed = v.record(v.string(), v.unknown())

const settled = async ({ database, steady, random }: Ports, classId: string) => {
  await settle(database.answers, classId, steady(), chanceOf(random))
  return inTime(await askingsOf(database.answers.db, classId))
}

const closed = (askings: readonly AskingRow[]) => askings.filter(({ state }) => state === 'closed')

/** How many have answered; null: some, and fewer than five. */
const shownCount = (count: number): number | null => (count > 0 && count < fewest ? null : count)

async function list({ ports, who }: Call<undefined>): Promise<Answer> {
  const askings = await settled(ports, who.class!.id)
  const keys = askings.map(({ key }) => key)
  const counts = await countsOf(ports.database.answers.db, keys)
  const papers = await papersOf(ports.database.answers.db, keys)
  const shown = askings.map((asking) => {
    const { form, text } = askedIn(asking)
    const seconds = asking.closesAt === null ? null : Math.ceil((asking.closesAt - ports.steady()) / 1000)
    const { state, grade } = asking
    return {
      form,
      text,
      state,
      grade,
      seconds,
      came: shownCount(counts.get(asking.key) ?? 0),
      paper: sheetsOf(papers, asking.key),
    }
  })
  return { body: { askings: shown } }
}

/** How many sheets of paper were typed in for a form. */
const sheetsOf = (papers: Awaited<ReturnType<typeof papersOf>>, key: string): number =>
  papers.reduce((sum, { asking, n }) => (asking === key ? sum + n : sum), 0)

/** The form that is to be asked. @throws Refusal where there is none such, or one of the product's names it as its own */
async function formOf({ questionnaires }: Ports, body: Wanted): Promise<Asked> {
  const { forms, questions } = await questionnaires()
  const loaded = 'form' in body ? forms.find(({ form }) => form.id === body.form) : ownForm(body.own)
  if (!loaded) throw new Refusal(404, 'noSuchForm')
  const isOurs = forms.some(({ form }) => form.id === loaded.form.id)
  if ('own' in body && isOurs) throw new Refusal(422, 'formRefused')
  try {
    return { form: loaded.form, text: loaded.text, columns: columnsOf(loaded.form, questions) }
  } catch {
    throw new Refusal(422, 'formRefused')
  }
}

function ownForm(file: unknown): LoadedForm {
  try {
    return readFormFile(file)
  } catch {
    throw new Refusal(422, 'formRefused')
  }
}

/** Opens a form for the class, or opens it again. */
async function open({ ports, who, body }: Call<Wanted>): Promise<Answer> {
  const { id, grade } = who.class!
  const { db } = ports.database.answers
  const asked = await formOf(ports, body)
  const now = await openAskingOf(db, id)
  if (now && now.form !== asked.form.id) throw new Refusal(409, 'otherFormOpen')
  const before = await askingOf(db, id, asked.form.id)
  const document = JSON.stringify(asked)
  // What was asked in other words before would be counted together with it.
  if (before && 'own' in body && before.document !== document) throw new Refusal(409, 'formChanged')
  const made = newFormKey(ports.random)
  if (before) await openAgain(db, before, made)
  else {
    const key = Buffer.from(ports.random(16)).toString('hex')
    const day = ports.day(0)
    const row = { key, class: id, form: asked.form.id, document, grade: gradeIn(grade), day }
    await addAsking(db, { ...row, ...made, state: 'open', closesAt: null })
  }
  ports.live.changed(id)
  return {}
}

async function formAt({ ports, who, at }: Call<unknown>): Promise<AskingRow> {
  const found = await askingOf(ports.database.answers.db, who.class!.id, at['form']!)
  if (!found) throw new Refusal(404, 'noSuchForm')
  return found
}

/** Nobody begins any more; what is on its way is taken for a minute. */
async function close(call: Call<undefined>): Promise<Answer> {
  const { ports, who } = call
  const { key, state } = await formAt(call)
  if (state === 'open') await setState(ports.database.answers.db, key, 'closing', ports.steady() + grace)
  ports.live.changed(who.class!.id)
  return {}
}

/** What is published of all forms that are closed. */
async function publishedOf(ports: Ports, classId: string) {
  const chance = chanceOf(ports.random)
  const askings = closed(await settled(ports, classId))
  const published = await answersTo(ports.database.answers.db, classId, askings)
  const forms = askings.map((asking) => ({ id: asking.form, columns: askedIn(asking).columns }))
  return { chance, published, forms }
}

async function results({ ports, who }: Call<undefined>): Promise<Answer> {
  const { chance, published, forms } = await publishedOf(ports, who.class!.id)
  const columnsIn = (id: string) => forms.find((one) => one.id === id)?.columns
  const growths = published.release.comparisons.flatMap((comparison) => {
    const [before, after] = [columnsIn(comparison.before), columnsIn(comparison.after)]
    const growth = before && after && growthOf(comparison, before, after, published.answers)
    if (!growth) return []
    const scores = shuffled(growth.scores, chance)
    return [{ before: comparison.before, after: comparison.after, growth: { ...growth, scores } }]
  })
  const shown = forms.map(({ id, columns }) => ({
    form: id,
    tallies: talliesOf(id, columns, published).map((tally) => mixed(tally, chance)),
  }))
  return { body: { forms: shown, growths } }
}

/** Children whose answers are published, each a row: grades and what was chosen, in random order. */
async function rows(call: Call<undefined>): Promise<Answer> {
  const { form } = await formAt(call)
  const { chance, published, forms } = await publishedOf(call.ports, call.who.class!.id)
  const columns = forms.find(({ id }) => id === form)?.columns
  if (!columns) throw new Refusal(409, 'formOpen')
  const tallies = talliesOf(form, columns, published)
  return { body: { rows: rowsOf(form, columns, tallies, published, chance) } }
}

/** Counts from sheets of paper are added to the results: at most one sheet a pupil. */
async function typeIn(call: Call<{ readonly [name: string]: unknown }>): Promise<Answer> {
  const { ports, body } = call
  const asking = await formAt(call)
  const counts = paperIn({ ...body, form: asking.form })
  const id = Buffer.from(ports.random(16)).toString('hex')
  const tokens = await countPupils(ports.database.db, asking.class)
  if (!(await addPaper(ports.database.answers, asking, { id, counts, tokens })))
    throw new Refusal(409, 'tooManySheets')
  return {}
}

function paperIn(body: unknown) {
  try {
    return readPaper(body)
  } catch {
    throw new Refusal(400, 'notUnderstood')
  }
}

/** All that was typed in for a form goes. */
async function takeOut(call: Call<undefined>): Promise<Answer> {
  await removePaper(call.ports.database.answers.db, (await formAt(call)).key)
  return {}
}

export const questionnaireRoutes: readonly Route[] = [
  route('GET', '/classes/:class/questionnaires', ['owner'], list),
  route('POST', '/classes/:class/questionnaires', ['owner'], open, wanted, mostBytes),
  route('GET', '/classes/:class/questionnaires/results', ['owner'], results),
  route('POST', '/classes/:class/questionnaires/:form/close', ['owner'], close),
  route('GET', '/classes/:class/questionnaires/:form/rows', ['owner'], rows),
  route('POST', '/classes/:class/questionnaires/:form/paper', ['owner'], typeIn, typed, mostBytes),
  route('DELETE', '/classes/:class/questionnaires/:form/paper', ['owner'], takeOut),
]
