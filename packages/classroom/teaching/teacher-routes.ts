import * as v from 'valibot'
import type { Db } from '../database/database.ts'
import { cookie } from '../joining/cookies.ts'
import type { Ports } from '../ports.ts'
import { Refusal } from '../refusal.ts'
import { route, type Answer, type Call, type Route } from '../route.ts'
import { endSessionsOfTeacher } from './accounts-store.ts'
import { deleteForGood, withRoom } from './deleting.ts'
import { classesOf } from './classes-store.ts'
import { carryOut } from './deleting-store.ts'
import { knownCookie, knownWithout } from './known-device.ts'
import { allTeachers, isOnlyOperator } from './operators-store.ts'
import { newPassword, weaknessOf } from './passwords.ts'
import { provePassword } from './prove-password.ts'

/** Longer than any that was ever accepted. */
const password = v.pipe(v.string(), v.maxLength(200))
const change = v.strictObject({ password, newPassword })
const proof = v.strictObject({ password })
const named = v.strictObject({ username: v.pipe(v.string(), v.maxLength(100)) })

async function changePassword(call: Call<v.InferOutput<typeof change>>): Promise<Answer> {
  const { ports, who, body, headers } = call
  const { id, username } = who.teacher!
  await provePassword(ports, id, body.password)
  const classes = await classesOf(ports.database.db, id)
  const weakness = await weaknessOf(body.newPassword, [username, ...classes.map(({ name }) => name)])
  if (weakness !== null) throw new Refusal(400, weakness)
  await ports.accounts.change(headers, body.newPassword)
  // Streams of the session that stays are opened again; the others find that theirs has ended.
  ports.live.end(null, { teacher: id }, 'again')
  return {}
}

async function refuseOwner(db: Db, id: string): Promise<void> {
  const names = (await classesOf(db, id)).map(({ name }) => name)
  if (names.length > 0) throw new Refusal(409, 'ownsClasses', { classes: names.join(', ') })
}

/** @throws Refusal 409 for a teacher with classes, whose account stays */
async function deleteTeacher(ports: Ports, id: string): Promise<void> {
  const { database, live } = ports
  const tombstone = { kind: 'teacher', id } as const
  const erase = async (inside: Db) => {
    // Only a deletion that succeeds leaves a tombstone, which is on the disk before the commit.
    await refuseOwner(inside, id)
    await carryOut(inside, tombstone)
    await ports.bury(tombstone)
  }
  await withRoom(ports, () => database.db.transaction().execute(erase))
  database.emptyJournal()
  live.end(null, { teacher: id }, 'signedOut')
}

async function deleteOwn(call: Call<v.InferOutput<typeof proof>>): Promise<Answer | Response> {
  const { ports, who, body, headers, caller } = call
  const { id, username } = who.teacher!
  await provePassword(ports, id, body.password)
  if (await isOnlyOperator(ports.database.db, id)) throw new Refusal(409, 'onlyOperator')
  await deleteTeacher(ports, id)
  const signedOut = await ports.accounts.forward('/sign-out', headers, '{}')
  await signedOut.body?.cancel()
  const known = cookie(knownCookie, knownWithout(ports.secret, headers, username.toLowerCase()), caller)
  return { cookies: [...signedOut.headers.getSetCookie(), known] }
}

async function teachers({ ports }: Call<undefined>): Promise<Answer> {
  return { body: { teachers: await allTeachers(ports.database.db) } }
}

/** With all classes of the teacher: there is no other owner who could keep them. */
async function deleteOther(call: Call<v.InferOutput<typeof named>>): Promise<Answer> {
  const { ports, who, body, at } = call
  const id = at['teacher']!
  const found = (await allTeachers(ports.database.db)).find((teacher) => teacher.id === id)
  if (!found) throw new Refusal(404, 'noSuchTeacher')
  if (id === who.teacher!.id) throw new Refusal(409, 'ownAccount')
  if (body.username.trim().toLowerCase() !== found.username.toLowerCase())
    throw new Refusal(400, 'otherUsername')
  await endSessionsOfTeacher(ports.database.db, id)
  for (const one of await classesOf(ports.database.db, id)) {
    await deleteForGood(ports, { kind: 'class', id: one.id })
    ports.live.end(one.id, 'everybody', 'ended')
  }
  await deleteTeacher(ports, id)
  return {}
}

export const teacherRoutes: readonly Route[] = [
  route('POST', '/teachers/me/password', ['teacher'], changePassword, change),
  route('DELETE', '/teachers/me', ['teacher'], deleteOwn, proof),
  route('GET', '/teachers', ['operator'], teachers),
  route('DELETE', '/teachers/:teacher', ['operator'], deleteOther, named),
]
