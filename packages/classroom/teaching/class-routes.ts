import * as v from 'valibot'
import type { ClassRow } from '../database/tables.ts'
import { newToken } from '../hashes.ts'
import { newCode, codeKey } from '../joining/code.ts'
import { endSessionsOfClass } from '../joining/sessions-store.ts'
import type { Ports } from '../ports.ts'
import { mostSpace } from '../projects/space-store.ts'
import { Refusal } from '../refusal.ts'
import { route, type Answer, type Call, type Route } from '../route.ts'
import { addClass, changeClass, classesOf, closeClass, giveCode, sizesOf } from './classes-store.ts'
import { deleteForGood } from './deleting.ts'
import { isHidden } from './ending-store.ts'
import { hiddenClass, languageOf, shownClass } from './shown.ts'

const joiningLength = 20 * 60_000

const name = v.pipe(v.string(), v.trim(), v.minLength(1), v.maxLength(40))
const language = v.picklist(['de', 'en'])
const grade = v.pipe(v.number(), v.integer(), v.minValue(1), v.maxValue(13))
const day = v.pipe(v.string(), v.isoDate())
const newClass = v.strictObject({ name, language, grade, endsOn: day })
const changes = v.partial(v.strictObject({ name, grade, endsOn: day }))

async function list({ ports, who }: Call<undefined>): Promise<Answer> {
  const rows = await classesOf(ports.database.db, who.teacher!.id)
  const show = async (row: ClassRow) =>
    (await isHidden(ports, row)) ? hiddenClass(row) : shownClass(row, ports)
  return { body: { classes: await Promise.all(rows.map(show)) } }
}

/** A code that no other class has; words are drawn again where one is taken. */
async function withFreeCode(ports: Ports, language: 'de' | 'en', use: (code: string) => Promise<boolean>) {
  for (let tries = 0; tries < 5; tries++) if (await use(codeKey(newCode(language, ports.random))!)) return
  throw new Error('No free code was found.')
}

async function make({ ports, who, body }: Call<v.InferOutput<typeof newClass>>): Promise<Answer> {
  refusePast(ports, body.endsOn)
  const id = newToken(ports.random)
  const made = {
    openedAt: null,
    joiningUntil: 0,
    closedAt: 0,
    announcedDay: null,
    space: 0,
    madeAt: ports.now(),
    cards: null,
    level: null,
  }
  await withFreeCode(ports, body.language, (code) =>
    addClass(ports.database.db, { id, teacher: who.teacher!.id, code, ...body, ...made }),
  )
  return { status: 201, body: { id } }
}

function refusePast(ports: Ports, endsOn: string) {
  if (endsOn <= ports.day(0)) throw new Refusal(400, 'endsInThePast')
}

async function one({ ports, who }: Call<undefined>): Promise<Answer> {
  const row = who.class!
  const sizes = await sizesOf(ports.database.db, row.id)
  return { body: { ...shownClass(row, ports), ...sizes, space: row.space, mostSpace: mostSpace.class } }
}

async function change({ ports, who, body }: Call<v.InferOutput<typeof changes>>): Promise<Answer> {
  if (body.endsOn !== undefined) refusePast(ports, body.endsOn)
  if (Object.keys(body).length > 0) await changeClass(ports.database.db, who.class!.id, body)
  ports.live.changed(who.class!.id)
  return {}
}

/** The lesson begins, and for 20 minutes newcomers can join; asked again, they can for 20 more. */
async function open({ ports, who }: Call<undefined>): Promise<Answer> {
  const now = ports.now()
  const openedAt = who.class!.openedAt ?? now
  const joiningUntil = ports.steady() + joiningLength
  await changeClass(ports.database.db, who.class!.id, { openedAt, joiningUntil })
  ports.live.changed(who.class!.id)
  return { body: { joiningUntil: now + joiningLength } }
}

async function close({ ports, who }: Call<undefined>): Promise<Answer> {
  await closeClass(ports.database.db, who.class!.id)
  ports.live.askAttention(who.class!.id, false)
  ports.live.end(who.class!.id, 'pupils', 'closed')
  return {}
}

/** Who is in goes on; nobody joins any more. */
async function stopJoining({ ports, who }: Call<undefined>): Promise<Answer> {
  await changeClass(ports.database.db, who.class!.id, { joiningUntil: 0 })
  ports.live.changed(who.class!.id)
  return {}
}

async function otherCode({ ports, who }: Call<undefined>): Promise<Answer> {
  const { id } = who.class!
  await withFreeCode(ports, languageOf(who.class!), (code) => giveCode(ports.database.db, id, code))
  return {}
}

async function signOutAll({ ports, who }: Call<undefined>): Promise<Answer> {
  await endSessionsOfClass(ports.database.db, who.class!.id)
  ports.live.end(who.class!.id, 'pupils', 'signedOut')
  return {}
}

/** Deletes the class with all its data. */
async function remove({ ports, who, body }: Call<{ readonly name: string }>): Promise<Answer> {
  const { id, name } = who.class!
  if (body.name.trim() !== name) throw new Refusal(400, 'otherName')
  await deleteForGood(ports, { kind: 'class', id })
  ports.live.end(id, 'everybody', 'ended')
  return {}
}

export const classRoutes: readonly Route[] = [
  route('GET', '/classes', ['teacher'], list),
  route('POST', '/classes', ['teacher'], make, newClass),
  route('GET', '/classes/:class', ['owner'], one),
  route('PATCH', '/classes/:class', ['owner'], change, changes),
  route('DELETE', '/classes/:class', ['owner'], remove, v.strictObject({ name: v.string() })),
  route('POST', '/classes/:class/open', ['owner', 'substitute'], open),
  route('POST', '/classes/:class/close', ['owner', 'substitute'], close),
  route('POST', '/classes/:class/stop-joining', ['owner', 'substitute'], stopJoining),
  route('POST', '/classes/:class/code', ['owner'], otherCode),
  route('POST', '/classes/:class/sign-out-all', ['owner'], signOutAll),
]
