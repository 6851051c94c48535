import * as v from 'valibot'
import { Refusal } from '../refusal.ts'
import { route, type Answer, type Call, type Route } from '../route.ts'
import { endClasses } from './every-night.ts'
import { endedClasses } from './ending-store.ts'
import { daysNow, noteAnswer } from './running-days-store.ts'

/** Both dates, for the answer whether the clock is right. `last`: the last day of running before the doubt. */
async function clock({ ports }: Call<undefined>): Promise<Answer> {
  const { db } = ports.database
  const { last, doubt } = await daysNow({ db, clock: ports.day })
  const ended = (await endedClasses(db, ports.day)).length
  const state = { doubted: doubt !== null, denied: doubt?.denied ?? false, days: doubt?.days.length ?? 0 }
  return { body: { today: ports.day(0), last, ...state, ended } }
}

const answer = v.strictObject({
  right: v.boolean(),
  /** The day that the page showed: an answer about another clock does not count. */
  today: v.pipe(v.string(), v.isoDate()),
})

async function answered({ ports, body }: Call<v.InferOutput<typeof answer>>): Promise<Answer> {
  if (body.today !== ports.day(0)) throw new Refusal(409, 'otherDay')
  await noteAnswer({ db: ports.database.db, clock: ports.day }, body.right)
  if (body.right) await endClasses(ports)
  return {}
}

export const clockRoutes: readonly Route[] = [
  route('GET', '/clock', ['operator'], clock),
  route('POST', '/clock', ['operator'], answered, answer),
]
