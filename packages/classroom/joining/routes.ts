import * as v from 'valibot'
import { keyedHash, newToken, sameHash } from '../hashes.ts'
import { liveOfPupil } from '../live/me-live.ts'
import type { Ports } from '../ports.ts'
import { Refusal } from '../refusal.ts'
import { route, type Answer, type Call, type Route } from '../route.ts'
import { codeKey } from './code.ts'
import { cookie, pupilCookie } from './cookies.ts'
import { nicknameFrom, nicknameKey } from './nickname.ts'
import { newSecret, pictures } from './pictures.ts'
import {
  addPupil,
  classToJoin,
  countPupils,
  countWrongOf,
  pupilCalled,
  pupilOf,
  setHand,
  unlock,
} from './pupils-store.ts'
import { endSession, proveSession, startSession } from './sessions-store.ts'
import {
  countJoin,
  countWrong,
  countWrongPictures,
  refuseLockedDevice,
  refuseMoreJoins,
  refuseThrottled,
} from './throttle-store.ts'

/** A class of a school has up to 36 pupils. */
const mostPupils = 100

const short = v.pipe(v.string(), v.maxLength(100))
const threePictures = v.strictTuple([v.picklist(pictures), v.picklist(pictures), v.picklist(pictures)])

const clocked = ({ database, now, secret }: Ports) => ({ db: database.db, now: now(), secret })

/** Pictures are kept as a keyed hash: nobody reads them back, the teacher neither. */
export const hashOfPictures = ({ secret }: Ports, pupil: string, shown: readonly string[]) =>
  keyedHash(secret, 'pictures of', pupil, ...shown)

/** The class of a code. A wrong one, a closed one and one that never was are answered alike. */
async function classFor({ ports, triers, body }: Call<{ readonly code: string }>) {
  await refuseThrottled(clocked(ports), triers)
  // A code of no shape costs the same query.
  const found = await classToJoin(ports.database.db, codeKey(body.code) ?? '', ports.now())
  if (found) return found
  await countWrong(clocked(ports), triers)
  throw new Refusal(404, 'noOpenClass')
}

async function look(call: Call<{ readonly code: string }>): Promise<Answer> {
  const { name, language, grade } = await classFor(call)
  return { body: { name, language, grade } }
}

async function join(call: Call<{ readonly code: string; readonly nickname: string }>): Promise<Answer> {
  const { ports, body, caller, triers } = call
  const { id: classId } = await classFor(call)
  const nickname = nicknameFrom(body.nickname)
  if (nickname === null) throw new Refusal(400, 'nickname')
  await refuseMoreJoins(clocked(ports), triers)
  const id = newToken(ports.random)
  const secret = newSecret(ports.random)
  const token = await ports.database.db.transaction().execute(async (inside) => {
    if ((await countPupils(inside, classId)) >= mostPupils) throw new Refusal(409, 'classHasAll')
    const added = await addPupil(inside, {
      ...{ id, class: classId, nickname, nicknameKey: nicknameKey(nickname) },
      pictures: hashOfPictures(ports, id, secret),
      ...{ wrong: 0, lockedAt: null, handAt: null, isNew: 1, joinedAt: ports.now() },
    })
    if (!added) throw new Refusal(409, 'nicknameTaken')
    return await startSession(inside, ports, { id, class: classId })
  })
  await countJoin(clocked(ports), triers)
  ports.live.changed(classId, [id])
  const cookies = [cookie(pupilCookie, token, caller)]
  return { status: 201, body: { id, class: classId, nickname, pictures: secret }, cookies }
}

type Shown = v.InferOutput<typeof threePictures>

/** @throws Refusal where they are not this pupil's, or have been guessed at too often */
async function refuseWrongPictures(
  call: Call<unknown>,
  pupil: { id: string; pictures: string },
  shown: Shown,
) {
  const { ports, triers } = call
  const { db } = ports.database
  if (sameHash(hashOfPictures(ports, pupil.id, shown), pupil.pictures)) return
  await countWrongOf(db, pupil.id, ports.now())
  await countWrongPictures(clocked(ports), triers.device ?? triers.address)
  await countWrong(clocked(ports), triers)
  throw new Refusal(403, 'wrongPictures')
}

async function comeBack(
  call: Call<{ readonly code: string; readonly nickname: string; readonly pictures: Shown }>,
): Promise<Answer> {
  const { ports, body, caller, triers } = call
  const { db } = ports.database
  const { id: classId } = await classFor(call)
  await refuseLockedDevice(clocked(ports), triers.device ?? triers.address)
  const pupil = await pupilCalled(db, classId, nicknameKey(nicknameFrom(body.nickname) ?? ''))
  // Who is in the class is told to nobody who has no pictures.
  if (!pupil) return await refuseUnknown(call)
  if (pupil.lockedAt !== null) throw new Refusal(423, 'nicknameLocked')
  await refuseWrongPictures(call, pupil, body.pictures)
  await unlock(db, pupil.id)
  const token = await startSession(db, ports, pupil)
  const { id, nickname } = pupil
  return { body: { id, class: classId, nickname }, cookies: [cookie(pupilCookie, token, caller)] }
}

async function refuseUnknown({ ports, triers }: Call<unknown>): Promise<never> {
  await countWrongPictures(clocked(ports), triers.device ?? triers.address)
  await countWrong(clocked(ports), triers)
  throw new Refusal(403, 'wrongPictures')
}

const me = async ({ ports, who }: Call<undefined>): Promise<Answer> => ({
  body: await liveOfPupil(ports, who.pupil!),
})

async function showPictures(call: Call<{ readonly pictures: Shown }>): Promise<Answer> {
  const { ports, who, body, triers } = call
  const { db } = ports.database
  const { id, class: classId, session } = who.pupil!
  await refuseThrottled(clocked(ports), triers)
  await refuseLockedDevice(clocked(ports), triers.device ?? triers.address)
  const pupil = await pupilOf(db, classId, id)
  if (!pupil) throw new Refusal(401, 'join')
  if (pupil.lockedAt !== null) throw new Refusal(423, 'nicknameLocked')
  await refuseWrongPictures(call, pupil, body.pictures)
  await unlock(db, id)
  await proveSession(db, session, ports.now())
  return {}
}

async function leave({ ports, who, caller }: Call<undefined>): Promise<Answer> {
  await endSession(ports.database.db, who.pupil!.session)
  ports.live.end(who.pupil!.class, { pupil: who.pupil!.id }, 'signedOut')
  return { cookies: [cookie(pupilCookie, '', caller)] }
}

async function hand({ ports, who, body }: Call<{ readonly up: boolean }>): Promise<Answer> {
  const { id, class: classId } = who.pupil!
  await setHand(ports.database.db, id, body.up ? ports.now() : null)
  ports.live.changed(classId, [id])
  return {}
}

const code = v.strictObject({ code: short })
const joining = v.strictObject({ code: short, nickname: short })
const coming = v.strictObject({ code: short, nickname: short, pictures: threePictures })

export const joiningRoutes: readonly Route[] = [
  route('POST', '/look', ['anyone'], look, code),
  route('POST', '/join', ['anyone'], join, joining),
  route('POST', '/return', ['anyone'], comeBack, coming),
  route('GET', '/me', ['pupil', 'returning'], me),
  route(
    'POST',
    '/me/pictures',
    ['pupil', 'returning'],
    showPictures,
    v.strictObject({ pictures: threePictures }),
  ),
  route('POST', '/me/leave', ['pupil', 'returning'], leave),
  route('PUT', '/me/hand', ['pupil'], hand, v.strictObject({ up: v.boolean() })),
]
