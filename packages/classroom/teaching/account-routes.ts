import * as v from 'valibot'
import { newToken } from '../hashes.ts'
import { cookie, cookieIn, pupilCookie, substituteCookie } from '../joining/cookies.ts'
import type { Guess } from '../joining/guesses.ts'
import { readPupil } from '../joining/sessions-store.ts'
import { triersOfAccount, triersOfKnown } from '../joining/triers.ts'
import { liveOfPupil } from '../live/me-live.ts'
import type { Ports } from '../ports.ts'
import { Refusal } from '../refusal.ts'
import { route, type Answer, type Call, type Route } from '../route.ts'
import { mounted, type Mounted } from './accounts.ts'
import { endSessionsOfTeacher } from './accounts-store.ts'
import { deviceKnownTo, knownAfter, knownCookie } from './known-device.ts'
import { isHidden } from './ending-store.ts'
import { newPassword, weaknessOf } from './passwords.ts'
import { daysNow } from './running-days-store.ts'
import { classLent } from './substitutes-store.ts'
import { sizesOfAll } from './classes-store.ts'
import { addInvitation, firstTeacher, isOperator, makeOperator, takeInvitation } from './operators-store.ts'

const days = 86_400_000
const invitationLength = 7 * days

const username = v.pipe(v.string(), v.regex(/^[a-zA-Z0-9_.]{3,30}$/))
const token = v.pipe(v.string(), v.maxLength(100))
const newTeacher = v.strictObject({ token, username, password: newPassword })

/** Refusals of a pupil whose class was deleted, or has ended. */
const noLonger = new Set(['classEnded', 'classHidden'])

/** The pupil of a request, if one has joined on this device. `ended`: the class is no more; `hidden`: it has ended and is not deleted yet. */
async function pupilAsking(ports: Ports, headers: Headers) {
  try {
    const pupil = await readPupil(ports, cookieIn(headers, pupilCookie))
    return { pupil: pupil && (await liveOfPupil(ports, pupil)), ended: false, hidden: false }
  } catch (error) {
    if (!(error instanceof Refusal) || !noLonger.has(error.code)) throw error
    return { pupil: null, ended: error.code === 'classEnded', hidden: error.code === 'classHidden' }
  }
}

/** The class that a substitute has today. */
async function substituteAsking(ports: Ports, headers: Headers) {
  const { database, day } = ports
  const token = cookieIn(headers, substituteCookie)
  const lent = token === null ? undefined : await classLent(database.db, token, day(0))
  return lent && !(await isHidden(ports, lent)) ? { class: lent.id, name: lent.name } : null
}

/** Both dates of a clock that is doubted, for the doctor, who has no account; null for any other clock. */
async function doubtedClock({ database: { db }, day }: Ports) {
  const { last, doubt } = await daysNow({ db, clock: day })
  return doubt && { today: day(0), last, denied: doubt.denied }
}

/** What every page asks first: is there a class server with a teacher, and who sits here? */
async function state({ ports, headers, caller }: Call<undefined>): Promise<Answer> {
  const { db } = ports.database
  const first = await firstTeacher(db)
  const found = await ports.accounts.teacherOf(headers)
  // Anyone may ask: no name of an account. Pages of earlier versions expect the field.
  const firstMade = first ? { name: null, madeAt: first.madeAt } : null
  const teacher = found && { username: found.username, operator: await isOperator(db, found.id) }
  return {
    body: {
      ...{ firstTeacher: firstMade, secure: caller.secure, teacher },
      ...(await pupilAsking(ports, headers)),
      substitute: await substituteAsking(ports, headers),
      address: ports.announced(caller),
      clock: await doubtedClock(ports),
    },
  }
}

async function makeTeacher(call: Call<v.InferOutput<typeof newTeacher>>): Promise<Response> {
  const { ports, body, headers } = call
  const { db } = ports.database
  const weakness = await weaknessOf(body.password, [body.username])
  if (weakness !== null) throw new Refusal(400, weakness)
  const invitation = await takeInvitation(db, body.token, ports)
  if (!invitation) throw new Refusal(403, 'linkUsedUp')
  const id = await ports.accounts.create(body)
  if (id === null) {
    // The link goes on working for another name.
    await addInvitation(db, body.token, invitation.first, invitation.endsAt)
    throw new Refusal(409, 'usernameTaken')
  }
  if (invitation.first) {
    await makeOperator(db, id, ports.now())
    ports.teacherMade()
  }
  const credentials = JSON.stringify({ username: body.username, password: body.password })
  const answer = await ports.accounts.forward('/sign-in/username', headers, credentials)
  return signedIn(answer, rememberDevice(call, body.username))
}

/** Nothing of the account is told but that it worked; the cookies count. */
async function signedIn(answer: Response, ...further: readonly string[]): Promise<Response> {
  await answer.body?.cancel()
  const headers = new Headers()
  for (const cookie of answer.headers.getSetCookie()) headers.append('set-cookie', cookie)
  if (answer.ok) for (const cookie of further) headers.append('set-cookie', cookie)
  return new Response(null, { status: answer.ok ? 204 : answer.status, headers })
}

const signIn = v.strictObject({
  username: v.pipe(v.string(), v.maxLength(100)),
  password: v.pipe(v.string(), v.maxLength(200)),
})

/** A device that has signed in to the account before waits only for wrong passwords of its own. */
function beginSignIn({ ports, headers, triers }: Call<unknown>, username: string): Guess {
  const { secret, limits } = ports
  const account = username.toLowerCase()
  const device = deviceKnownTo(secret, headers, account)
  return device === null
    ? limits.guesses.signIns.begin(triersOfAccount(triers.address, account, secret))
    : limits.guesses.knownSignIns.begin(triersOfKnown(device, account, secret))
}

async function signInByName(call: Call<v.InferOutput<typeof signIn>>): Promise<Response> {
  const { ports, headers, body } = call
  const guess = beginSignIn(call, body.username)
  const answer = await signInWithRoom(ports, headers, JSON.stringify(body))
  if (answer.status >= 400 && answer.status < 500) {
    await answer.body?.cancel()
    const seconds = guess.wrong()
    throw seconds === 0 ? new Refusal(401, 'wrongPassword') : new Refusal(429, 'tooManyTries', { seconds })
  }
  guess.right()
  if (!answer.ok) throw databaseFailed(ports)
  return signedIn(answer, rememberDevice(call, body.username))
}

/** Bytes that a new session takes at most, with the pages of its journal. */
const roomOfSession = 1_000_000

/** better-auth hides the error of the database. */
const databaseFailed = ({ database, host }: Ports) =>
  database.kind === 'sqlite' && host.freeSpace() < roomOfSession
    ? new Refusal(507, 'diskFull')
    : new Refusal(503, 'busy')

/** Signs in also on a full disk: otherwise no teacher could delete anything. */
async function signInWithRoom({ accounts, host }: Ports, headers: Headers, body: string): Promise<Response> {
  const signIn = () => accounts.forward('/sign-in/username', headers, body)
  const answer = await signIn()
  if (answer.status < 500 || host.freeSpace() >= roomOfSession) return answer
  await answer.body?.cancel()
  host.useReserve(roomOfSession)
  return signIn()
}

/** A cookie by which this device is known to the account from now on. */
const rememberDevice = ({ ports, headers, caller }: Call<unknown>, username: string): string =>
  cookie(knownCookie, knownAfter(ports, headers, username.toLowerCase()), caller)

const forward =
  (path: Exclude<Mounted, '/sign-in/username'>) =>
  async ({ ports, headers, body }: Call<unknown>): Promise<Response> => {
    const text = body === undefined ? '{}' : JSON.stringify(body)
    const answer = await ports.accounts.forward(path, headers, text)
    return path === '/get-session' ? teacherOnly(answer) : signedIn(answer)
  }

/** The page needs the name alone. */
async function teacherOnly(answer: Response): Promise<Response> {
  const found = answer.ok ? ((await answer.json()) as { user: { displayUsername: string } } | null) : null
  return Response.json({ teacher: found ? { username: found.user.displayUsername } : null })
}

const routeOf: { readonly [path in Mounted]: Route } = {
  '/sign-in/username': route('POST', '/auth/sign-in/username', ['anyone'], signInByName, signIn),
  '/sign-out': route('POST', '/auth/sign-out', ['anyone'], forward('/sign-out')),
  '/get-session': route('GET', '/auth/get-session', ['anyone'], forward('/get-session')),
}

async function endAllSessions({ ports, who }: Call<undefined>): Promise<Answer> {
  await endSessionsOfTeacher(ports.database.db, who.teacher!.id)
  ports.live.end(null, { teacher: who.teacher!.id }, 'signedOut')
  return {}
}

async function invite({ ports }: Call<undefined>): Promise<Answer> {
  const link = newToken(ports.random)
  const endsAt = ports.now() + invitationLength
  await addInvitation(ports.database.db, link, 0, endsAt)
  return { status: 201, body: { token: link, endsAt } }
}

async function sizes({ ports }: Call<undefined>): Promise<Answer> {
  return { body: { classes: await sizesOfAll(ports.database.db) } }
}

export const accountRoutes: readonly Route[] = [
  route('GET', '/state', ['anyone'], state),
  route('POST', '/teachers', ['anyone'], makeTeacher, newTeacher),
  ...mounted.map((path) => routeOf[path]),
  route('POST', '/teachers/me/end-sessions', ['teacher'], endAllSessions),
  route('POST', '/invitations', ['operator'], invite),
  route('GET', '/sizes', ['operator'], sizes),
]
