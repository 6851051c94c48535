import { sendingSchema, type Entry } from '@botgarten/programs/together'
import * as v from 'valibot'
import { newToken } from '../hashes.ts'
import { pupilOf, pupilsOf } from '../joining/pupils-store.ts'
import { isHere } from '../live/tiles.ts'
import { wholeNumber } from '../projects/routes.ts'
import { Refusal } from '../refusal.ts'
import { route, type Answer, type Call, type Route } from '../route.ts'
import { classById } from '../teaching/classes-store.ts'
import type { PairRow } from '../database/together-tables.ts'
import {
  addEntries,
  addPair,
  changePair,
  deletePair,
  documentOf,
  entriesFrom,
  lockPair,
  otherInvitations,
  pairOf,
} from './pairs-store.ts'
import { otherOf, shownPair } from './shown.ts'

/** A pair has at most so many operations, of so many bytes together; and within ten seconds at most so many. */
const mostEntries = 20_000
const mostBytes = 5_000_000
const mostInWindow = 1000
const window = 10_000
/** What is sent and answered at once. */
const mostOfSending = 400_000
const mostAnswered = 500

/** Who asks. @throws Refusal unless the teacher lets two work on one program */
async function allowed({ ports, who }: Call<unknown>) {
  const pupil = who.pupil!
  if ((await classById(ports.database.db, pupil.class))?.together !== 1) throw new Refusal(403, 'togetherOff')
  return pupil
}

/** The pair of the pupil who asks. @throws Refusal where there is none */
async function ownPair({ ports, who }: Call<unknown>): Promise<PairRow> {
  const pair = await pairOf(ports.database.db, who.pupil!.id)
  if (!pair) throw new Refusal(404, 'noPair')
  return pair
}

async function workingPair(call: Call<unknown>): Promise<PairRow> {
  const pair = await ownPair(call)
  if (pair.accepted === 0) throw new Refusal(404, 'noPair')
  return pair
}

const tellBoth = ({ ports }: Call<unknown>, { class: classId, inviter, invited }: PairRow) =>
  ports.live.changed(classId, [inviter, invited])

const isAtWork = ({ accepted, left }: PairRow) => accepted === 1 && left === null

/** Classmates who are here now. */
async function mates(call: Call<undefined>): Promise<Answer> {
  const { ports } = call
  const { id: own, class: classId } = await allowed(call)
  const now = ports.now()
  const here = (await pupilsOf(ports.database.db, classId)).filter(
    ({ id }) => id !== own && isHere({ live: ports.live.liveOf(classId, id) }, now),
  )
  return { body: { mates: here.map(({ id, nickname }) => ({ id, nickname })) } }
}

/** Asks a classmate to work on this project together. An earlier invitation of the same pupil is over with it. */
async function invite(call: Call<string>): Promise<Answer> {
  const { ports, query, body } = call
  const { id: inviter, class: classId } = await allowed(call)
  const { db } = ports.database
  const invited = query.get('to') ?? ''
  // Two devices of one child are not a pair.
  if (invited === inviter || !(await pupilOf(db, classId, invited))) throw new Refusal(404, 'noSuchPupil')
  const checked = await ports.checkProject(body, { class: classId, pupil: inviter })
  if ('refused' in checked) throw new Refusal(422, 'projectRefused', { reason: checked.refused })
  // A photo would reach another child without the teacher's yes.
  if (checked.assets.length > 0) throw new Refusal(409, 'ownPhoto')
  const before = await pairOf(db, inviter)
  if (before && (isAtWork(before) || before.invited === inviter)) throw new Refusal(409, 'inPair')
  const theirs = await pairOf(db, invited)
  if (theirs && isAtWork(theirs)) throw new Refusal(409, 'mateInPair')
  const [id, at] = [newToken(ports.random), ports.now()]
  await db.transaction().execute(async (inside) => {
    if (before) await deletePair(inside, before.id)
    await addPair(inside, {
      ...{ id, class: classId, inviter, invited, title: checked.name.slice(0, 100) },
      ...{ accepted: 0, left: null, hand: inviter, length: 0, bytes: 0, ofInviter: 0, ofInvited: 0 },
      ...{ windowEndsAt: 0, inWindow: 0, at, document: checked.document },
    })
  })
  ports.live.changed(classId, [inviter, invited, ...(before ? [before.invited] : [])])
  return { status: 201, body: { id } }
}

async function answer(call: Call<{ readonly pair: string; readonly yes: boolean }>): Promise<Answer> {
  const { ports, who, body } = call
  const { db } = ports.database
  const pair = await ownPair(call)
  if (pair.id !== body.pair || pair.invited !== who.pupil!.id || pair.accepted === 1)
    throw new Refusal(404, 'noPair')
  if (body.yes) {
    await changePair(db, pair.id, { accepted: 1 })
    // Others whom they have asked, or who ask them, ask no more.
    for (const pupil of [pair.inviter, pair.invited])
      for (const gone of await otherInvitations(db, pupil, pair.id))
        ports.live.changed(pair.class, [gone.inviter, gone.invited])
  } else await deletePair(db, pair.id)
  tellBoth(call, pair)
  return {}
}

/** Where the pair stands: without `from` also what they began with, else the common order from there on. */
async function read(call: Call<undefined>): Promise<Answer> {
  const { ports, who, query } = call
  const { db } = ports.database
  const pair = await workingPair(call)
  const from = query.get('from')
  const entries = await entriesFrom(db, pair.id, wholeNumber(from ?? '0'), mostAnswered)
  const project = from === null ? { project: JSON.parse(await documentOf(db, pair.id)) as unknown } : {}
  return {
    body: { ...(await shownPair(db, who.pupil!.id)), length: pair.length, entries, ...project },
  }
}

type Sending = v.InferOutput<typeof sendingSchema>

/** Puts operations at the end of the common order. What was sent before is left out. */
async function send(call: Call<Sending>): Promise<Answer> {
  const { ports, who } = call
  const own = await workingPair(call)
  const length = await ports.database.db.transaction().execute(async (inside) => {
    const pair = await lockPair(inside, own.id)
    if (!pair) throw new Refusal(404, 'noPair')
    const entries = freshOf(pair, who.pupil!.id, call.body)
    if (entries.length === 0) return pair.length
    await addEntries(inside, pair, entries, limited(pair, entries, ports.steady()))
    return pair.length + entries.length
  })
  ports.live.tell(own.class, otherOf(own, who.pupil!.id), 'pair', { length })
  return { body: { length } }
}

/** What of a sending is new. Its author's count has no gaps, and nobody has seen what is not there yet. */
function freshOf(pair: PairRow, pupil: string, { ops }: Sending): Entry[] {
  const by = pupil === pair.inviter ? 'a' : 'b'
  const last = by === 'a' ? pair.ofInviter : pair.ofInvited
  const fresh = ops.filter(({ n }) => n > last)
  if (!fresh.every(({ n, base }, k) => n === last + k + 1 && base <= pair.length))
    throw new Refusal(400, 'notUnderstood')
  return fresh.map((op) => ({ by, ...op }))
}

/** How much there is with these. @throws Refusal where that is too much, altogether or for now */
function limited(pair: PairRow, entries: readonly Entry[], now: number) {
  const bytes = pair.bytes + entries.reduce((sum, { op }) => sum + JSON.stringify(op).length, 0)
  if (pair.length + entries.length > mostEntries || bytes > mostBytes) throw new Refusal(409, 'pairFull')
  const isNew = now >= pair.windowEndsAt
  const inWindow = (isNew ? 0 : pair.inWindow) + entries.length
  if (inWindow > mostInWindow)
    throw new Refusal(429, 'tooManyTries', { seconds: Math.ceil((pair.windowEndsAt - now) / 1000) })
  return { bytes, inWindow, windowEndsAt: isNew ? now + window : pair.windowEndsAt }
}

const block = v.nullable(v.pipe(v.string(), v.minLength(1), v.maxLength(200)))
const share = v.pipe(v.number(), v.minValue(0), v.maxValue(1))
const pointing = v.strictObject({ program: block, at: block, x: share, y: share, chosen: block })

/** Where the hand is: over which block of which program, at which share of its width and height, and which one is chosen. Not stored. */
async function point(call: Call<v.InferOutput<typeof pointing>>): Promise<Answer> {
  const { ports, who, body } = call
  const pair = await workingPair(call)
  ports.live.tell(pair.class, otherOf(pair, who.pupil!.id), 'hand', body)
  return {}
}

/** The two swap: who was the hand is the eye. Either may edit. */
async function swap(call: Call<{ readonly role: 'hand' | 'eye' }>): Promise<Answer> {
  const { ports, who, body } = call
  const pair = await workingPair(call)
  const { id } = who.pupil!
  await changePair(ports.database.db, pair.id, { hand: body.role === 'hand' ? id : otherOf(pair, id) })
  tellBoth(call, pair)
  return {}
}

/** Leaves, or takes an invitation back. What was done stays until the other one has left, too. */
async function leave(call: Call<undefined>): Promise<Answer> {
  const { ports, who } = call
  const { db } = ports.database
  const pair = await ownPair(call)
  if (pair.accepted === 0 || pair.left !== null) await deletePair(db, pair.id)
  else await changePair(db, pair.id, { left: who.pupil!.id })
  tellBoth(call, pair)
  return {}
}

const id = v.pipe(v.string(), v.regex(/^[\w-]{1,64}$/))

export const togetherRoutes: readonly Route[] = [
  route('GET', '/pair/mates', ['pupil'], mates),
  route('POST', '/pair', ['pupil'], invite, 'project'),
  route('PUT', '/pair/answer', ['pupil'], answer, v.strictObject({ pair: id, yes: v.boolean() })),
  route('GET', '/pair', ['pupil'], read),
  route('POST', '/pair/operations', ['pupil'], send, sendingSchema, mostOfSending),
  route('PUT', '/pair/hand', ['pupil'], point, pointing),
  route('PUT', '/pair/role', ['pupil'], swap, v.strictObject({ role: v.picklist(['hand', 'eye']) })),
  route('DELETE', '/pair', ['pupil'], leave),
]
