import * as v from 'valibot'
import { newToken } from '../hashes.ts'
import { cookie, substituteCookie } from '../joining/cookies.ts'
import { Refusal } from '../refusal.ts'
import { route, type Answer, type Call, type Route } from '../route.ts'
import { refuseHidden } from './ending-store.ts'
import { addSubstitute, classLent, endSubstitutes } from './substitutes-store.ts'

/** A link for somebody who takes the class today. */
async function invite({ ports, who }: Call<undefined>): Promise<Answer> {
  const [token, day] = [newToken(ports.random), ports.day(0)]
  await addSubstitute(ports.database.db, token, who.class!.id, day)
  return { status: 201, body: { token, day } }
}

async function end({ ports, who }: Call<undefined>): Promise<Answer> {
  await endSubstitutes(ports.database.db, who.class!.id)
  ports.live.end(who.class!.id, 'substitutes', 'signedOut')
  return {}
}

const wholeDay = 24 * 3600

async function begin({ ports, body, caller }: Call<{ readonly token: string }>): Promise<Answer> {
  const found = await classLent(ports.database.db, body.token, ports.day(0))
  if (!found) throw new Refusal(403, 'linkUsedUp')
  await refuseHidden(ports, found)
  const { id, name } = found
  return { body: { id, name }, cookies: [cookie(substituteCookie, body.token, caller, wholeDay)] }
}

const leave = ({ caller }: Call<undefined>): Promise<Answer> =>
  Promise.resolve({ cookies: [cookie(substituteCookie, '', caller)] })

const token = v.pipe(v.string(), v.maxLength(100))

export const substituteRoutes: readonly Route[] = [
  route('POST', '/classes/:class/substitute', ['owner'], invite),
  route('DELETE', '/classes/:class/substitute', ['owner'], end),
  route('POST', '/substitute', ['anyone'], begin, v.strictObject({ token })),
  route('POST', '/substitute/leave', ['anyone'], leave),
]
