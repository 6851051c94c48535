import * as v from 'valibot'
import { isHere } from '../live/tiles.ts'
import type { Ports } from '../ports.ts'
import { Refusal } from '../refusal.ts'
import { route, type Answer, type Call, type Route } from '../route.ts'
import { classById } from '../teaching/classes-store.ts'
import { answerTo, ask, finishedBy, takeBack } from './peers-store.ts'

const id = v.pipe(v.string(), v.regex(/^[\w-]{1,64}$/))

/** Who asks. @throws Refusal unless the teacher lets pupils ask each other */
async function asking({ ports, who }: Call<unknown>) {
  const pupil = who.pupil!
  if ((await classById(ports.database.db, pupil.class))?.asking !== 1) throw new Refusal(403, 'askingOff')
  return pupil
}

/** Classmates who are here now and have passed all start places of a card. */
async function helpers(ports: Ports, classId: string, card: string, pupil: string) {
  const starts = (await ports.cards()).find((one) => one.id === card)?.starts ?? 0
  if (starts === 0) return []
  const done = await finishedBy(ports.database.db, classId, card, starts, pupil)
  const now = ports.now()
  return done.filter((one) => isHere({ live: ports.live.liveOf(classId, one.id) }, now))
}

async function list(call: Call<undefined>): Promise<Answer> {
  const pupil = await asking(call)
  const card = v.safeParse(id, call.query.get('card'))
  if (!card.success) throw new Refusal(400, 'notUnderstood')
  return { body: { helpers: await helpers(call.ports, pupil.class, card.output, pupil.id) } }
}

async function put(call: Call<{ readonly card: string; readonly to: string }>): Promise<Answer> {
  const { ports, body } = call
  const { id: pupil, class: classId } = await asking(call)
  const can = await helpers(ports, classId, body.card, pupil)
  if (!can.some((one) => one.id === body.to)) throw new Refusal(404, 'noSuchPupil')
  const { db } = ports.database
  const before = await takeBack(db, pupil)
  await ask(db, { pupil, class: classId, to: body.to, card: body.card, at: ports.now(), answer: null })
  ports.live.changed(classId, [pupil, body.to, ...(before === null ? [] : [before])])
  return {}
}

async function remove({ ports, who }: Call<undefined>): Promise<Answer> {
  const { id: pupil, class: classId } = who.pupil!
  const to = await takeBack(ports.database.db, pupil)
  if (to !== null) ports.live.changed(classId, [pupil, to])
  return {}
}

async function answer({
  ports,
  who,
  at,
  body,
}: Call<{ readonly answer: 'coming' | 'notNow' }>): Promise<Answer> {
  const { id: to, class: classId } = who.pupil!
  const pupil = at['pupil']!
  if (!(await answerTo(ports.database.db, pupil, to, body.answer))) throw new Refusal(404, 'noSuchQuestion')
  ports.live.changed(classId, [pupil, to])
  return {}
}

export const askingRoutes: readonly Route[] = [
  route('GET', '/me/helpers', ['pupil'], list),
  route('PUT', '/me/question', ['pupil'], put, v.strictObject({ card: id, to: id })),
  route('DELETE', '/me/question', ['pupil'], remove),
  route(
    'PUT',
    '/me/questions/:pupil',
    ['pupil'],
    answer,
    v.strictObject({ answer: v.picklist(['coming', 'notNow']) }),
  ),
]
