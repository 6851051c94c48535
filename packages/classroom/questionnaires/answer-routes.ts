// What children's devices send without a cookie: nothing of it says who they are.
import type { Answer as Given } from '@botgarten/answers'
import * as v from 'valibot'
import { keyedHash } from '../hashes.ts'
import { cookieIn, deviceCookie, pupilCookie } from '../joining/cookies.ts'
import type { Ports } from '../ports.ts'
import { Refusal } from '../refusal.ts'
import { route, type Call, type Route } from '../route.ts'
import { classById } from '../teaching/classes-store.ts'
import { refuseHidden } from '../teaching/ending-store.ts'
import { hasAnswer, hasCode, takeAnswer } from './answers-store.ts'
import { askingByKey, openAskingOf } from './askings-store.ts'
import { readSent } from './asked.ts'
import { chanceOf } from './chance.ts'
import { reserveCode } from './codes-store.ts'
import { checkToken, token } from './tokens.ts'

/** More children than any class has. */
const mostAnswers = 300
const mostBytes = 100_000
/** Requests that a request with a token counts as: checking it takes some 4 ms. A class behind one address sends about one a second. */
const cost = 3

const hex = v.pipe(v.string(), v.regex(/^[0-9a-f]{32}$/))
const sent = v.strictObject({
  key: hex,
  id: hex,
  code: v.nullable(v.string()),
  values: v.record(v.string(), v.string()),
  token: v.optional(token),
})
const chosen = v.strictObject({
  ...{ key: hex, id: hex, code: v.pipe(v.string(), v.maxLength(40)) },
  token: v.optional(token),
})

/** No cookie is set, so that none is sent the next time. */
const done = (body?: unknown) =>
  body === undefined ? new Response(null, { status: 204 }) : Response.json(body)

/** A page that sends along who sits there has a fault that would join an answer to a pupil. */
function refuseKnown(headers: Headers): void {
  if ([pupilCookie, deviceCookie].some((name) => cookieIn(headers, name) !== null))
    throw new Refusal(400, 'withCookie')
}

/** No pupil is known here, so it is the address that is slowed down: in memory, and never stored. */
function admit({ ports, headers, triers }: Pick<Call<unknown>, 'ports' | 'headers' | 'triers'>): void {
  refuseKnown(headers)
  ports.limits.request(`answers from ${triers.address}`, cost)
}

async function asking(ports: Ports, key: string) {
  const found = await askingByKey(ports.database.answers.db, key)
  if (!found) throw new Refusal(404, 'noSuchForm')
  await refuseHiddenClass(ports, found.class)
  return found
}

async function refuseHiddenClass(ports: Ports, id: string): Promise<void> {
  const row = await classById(ports.database.db, id)
  if (row) await refuseHidden(ports, row)
}

function readAs(read: () => Given): Given {
  try {
    return read()
  } catch {
    throw new Refusal(400, 'notUnderstood')
  }
}

async function take(call: Call<v.InferOutput<typeof sent>>): Promise<Response> {
  const { ports, body } = call
  admit(call)
  const { database, random, steady } = ports
  const row = await asking(ports, body.key)
  const { key: _, token: sent, ...given } = body
  const { id, code, values } = readAs(() => readSent(row, given))
  checkToken(row, id, sent)
  const isOver = row.state === 'closed' || (row.state === 'closing' && (row.closesAt ?? 0) <= steady())
  if (isOver) {
    if (await hasAnswer(database.answers.db, row.key, id)) return done()
    throw new Refusal(409, 'formClosed')
  }
  const answer = { asking: row.key, id, code, chosen: JSON.stringify(values) }
  const taken = await takeAnswer(database.answers, row, answer, mostAnswers, chanceOf(random))
  if (taken === 'full') throw new Refusal(409, 'formFull')
  if (taken === 'other') throw new Refusal(422, 'tokenSpent')
  return done()
}

/** Has another child of the class chosen this code for this form? If not, it is this one's. */
async function choose(call: Call<v.InferOutput<typeof chosen>>): Promise<Response> {
  const { ports, body } = call
  admit(call)
  const { key, id, code } = body
  const { database, secret, random } = ports
  const row = await asking(ports, key)
  readAs(() => readSent(row, { id, code, values: {} }))
  checkToken(row, id, body.token)
  if (await hasCode(database.answers.db, key, code, id)) return done({ taken: true })
  if (row.state !== 'open') return done({ taken: false })
  const owner = keyedHash(secret, 'answer of', key, id)
  const wanted = { code: keyedHash(secret, 'code of', key, code), owner }
  const isReserved = await reserveCode(database.answers, row, wanted, chanceOf(random))
  return done({ taken: !isReserved })
}

/**
 * The key of the form that is open for a class, without a cookie. A page refuses a token that was made with another key, so that
 * no child can be marked by a key of its own.
 */
async function publicKey({ ports, headers, query }: Call<undefined>): Promise<Response> {
  refuseKnown(headers)
  const row = await openAskingOf(ports.database.answers.db, query.get('class') ?? '')
  if (!row) throw new Refusal(404, 'noSuchForm')
  await refuseHiddenClass(ports, row.class)
  return done({ key: row.key, publicKey: row.publicKey })
}

export const answerRoutes: readonly Route[] = [
  route('GET', '/answers/key', ['anyone'], publicKey),
  route('POST', '/answers', ['anyone'], take, sent, mostBytes),
  route('POST', '/answers/code', ['anyone'], choose, chosen),
]
