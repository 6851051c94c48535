import { betterAuth } from 'better-auth'
import { username } from 'better-auth/plugins/username'
import * as v from 'valibot'
import type { Database } from '../database/database.ts'
import { keyedHash } from '../hashes.ts'
import { Refusal } from '../refusal.ts'
import {
  endOtherSessions,
  endSessionsOfTeacher,
  passwordHashOf,
  setPassword,
  teacherCalled,
} from './accounts-store.ts'

/** A teacher who is signed in. */
export interface Teacher {
  readonly id: string
  /** As it was typed when the account was made. */
  readonly username: string
}

/** Of better-auth's paths only these are mounted. */
export const mounted = ['/sign-in/username', '/sign-out', '/get-session'] as const
export type Mounted = (typeof mounted)[number]

const sessionAnswer = v.nullable(
  v.object({
    session: v.object({ id: v.string(), expiresAt: v.pipe(v.string(), v.toDate()) }),
    user: v.object({ id: v.string(), displayUsername: v.string() }),
  }),
)

interface NewTeacher {
  readonly username: string
  readonly password: string
}

export interface Accounts {
  /** Takes a request to one of the mounted paths. `body`: JSON text, already limited. */
  forward(path: Mounted, headers: Headers, body: string | null): Promise<Response>
  /** Who is signed in; null for nobody. */
  teacherOf(headers: Headers): Promise<Teacher | null>
  /** @returns the teacher's id; null where the name is taken */
  create(teacher: NewTeacher): Promise<string | null>
  /** Is this the password of a teacher? @param id of the teacher */
  isPassword(id: string, password: string): Promise<boolean>
  /** Gives the teacher who is signed in a new password and ends the other sessions. @param headers with the session that stays */
  change(headers: Headers, password: string): Promise<void>
  /** Gives a teacher a new password and ends all sessions. @returns whether there is such a teacher */
  reset(teacher: NewTeacher): Promise<boolean>
}

/** The address of a request that no proxy or browser has a say in. */
const inside = 'http://class.internal'
const basePath = '/api/class/auth'
const sessionSeconds = 12 * 3600
/** By how much a clock may be put right, or differ from that of another node, before sessions end. */
const clockSlackSeconds = 600

/** How passwords are hashed: scrypt where nothing else is given. */
export interface Hashing {
  readonly hash: (password: string) => Promise<string>
  readonly verify: (attempt: { readonly hash: string; readonly password: string }) => Promise<boolean>
}

function options(database: Database, secret: Uint8Array, hashing?: Hashing) {
  return {
    appName: 'Botgarten',
    baseURL: inside,
    basePath,
    secret: keyedHash(secret, 'accounts'),
    database: { db: database.db, type: database.kind },
    telemetry: { enabled: false },
    logger: { disabled: true },
    emailAndPassword: {
      ...{ enabled: true, disableSignUp: true, minPasswordLength: 10, maxPasswordLength: 128 },
      ...(hashing && { password: hashing }),
    },
    user: { modelName: 'teacher' },
    session: { modelName: 'teacherSession', expiresIn: sessionSeconds, disableSessionRefresh: true },
    plugins: [username({ minUsernameLength: 3, maxUsernameLength: 30 })],
    // Wrong tries are counted before better-auth sees them: it would refuse right passwords too, by address.
    rateLimit: { enabled: false },
    advanced: {
      cookiePrefix: 'botgarten-teacher',
      // The server adds Secure to the answer to a request that came over https.
      useSecureCookies: false,
      defaultCookieAttributes: { path: '/api/class' },
      ipAddress: { disableIpTracking: true },
    },
    databaseHooks: {
      session: {
        create: {
          before: (session: object) =>
            Promise.resolve({ data: { ...session, ipAddress: '', userAgent: '' } }),
        },
      },
    },
  }
}

/**
 * Accounts of teachers: better-auth on our tables.
 *
 * @param secret keys its cookies
 * @param now the clock that better-auth uses: milliseconds since 1970
 */
export function accountsOn(
  database: Database,
  secret: Uint8Array,
  now: () => number,
  hashing?: Hashing,
): Accounts {
  const auth = betterAuth(options(database, secret, hashing))

  function forward(path: Mounted, headers: Headers, body: string | null) {
    const given: Record<string, string> = { origin: inside, cookie: headers.get('cookie') ?? '' }
    if (body !== null) given['content-type'] = 'application/json'
    const method = path === '/get-session' ? 'GET' : 'POST'
    const url = `${inside}${basePath}${path}`
    return auth.handler(new Request(url, { method, headers: given, body: method === 'GET' ? null : body }))
  }

  async function sessionOf(headers: Headers) {
    if (!headers.get('cookie')?.includes('botgarten-teacher')) return null
    const answer = await forward('/get-session', headers, null)
    // better-auth hides what the database said.
    if (!answer.ok) throw new Refusal(503, 'busy')
    const found = v.parse(sessionAnswer, await answer.json())
    // Signed in while the clock was ahead: without this the session would last until the clock gets there.
    const latest = now() + (sessionSeconds + clockSlackSeconds) * 1000
    return found && found.session.expiresAt.getTime() > latest ? null : found
  }

  async function teacherOf(headers: Headers): Promise<Teacher | null> {
    const found = await sessionOf(headers)
    return found && { id: found.user.id, username: found.user.displayUsername }
  }

  async function create({ username, password }: NewTeacher): Promise<string | null> {
    const { internalAdapter, password: hashing } = await auth.$context
    if (await teacherCalled(database.db, username)) return null
    // Nobody is asked for a mail address; the column wants one of its own for each.
    const email = `${username.toLowerCase()}@botgarten.invalid`
    const made = { name: username, email, emailVerified: false, username, displayUsername: username }
    const teacher = await internalAdapter.createUser(made, { method: 'admin' })
    const credential = { userId: teacher.id, accountId: teacher.id, providerId: 'credential' }
    await internalAdapter.linkAccount({ ...credential, password: await hashing.hash(password) })
    return teacher.id
  }

  async function change(headers: Headers, password: string): Promise<void> {
    const found = await sessionOf(headers)
    if (!found) throw new Refusal(401, 'signIn')
    const { password: hashing } = await auth.$context
    const hash = await hashing.hash(password)
    await database.db.transaction().execute(async (inside) => {
      await setPassword(inside, found.user.id, hash)
      await endOtherSessions(inside, found.user.id, found.session.id)
    })
  }

  async function reset({ username, password }: NewTeacher): Promise<boolean> {
    const { password: hashing } = await auth.$context
    const { db } = database
    const teacher = await teacherCalled(db, username)
    if (teacher === undefined) return false
    await setPassword(db, teacher, await hashing.hash(password))
    await endSessionsOfTeacher(db, teacher)
    return true
  }

  async function isPassword(id: string, password: string): Promise<boolean> {
    const { password: hashing } = await auth.$context
    const hash = await passwordHashOf(database.db, id)
    return hash !== null && (await hashing.verify({ hash, password }))
  }

  return { forward, teacherOf, create, isPassword, change, reset }
}
