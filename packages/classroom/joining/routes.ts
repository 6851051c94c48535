import * as v from 'valibot'
import type { NewPupil } from '../database/tables.ts'
import { newToken } from '../hashes.ts'
import { liveOfPupil } from '../live/me-live.ts'
import type { Ports } from '../ports.ts'
import { Refusal, WrongTry } from '../refusal.ts'
import { route, type Answer, type Call, type Route } from '../route.ts'
import { codeKey, isShortCode } from './code.ts'
import { cookie, cookieIn, deviceCookie, pupilCookie } from './cookies.ts'
import { countJoin, refuseMoreJoins } from './joins-store.ts'
import { nicknameFrom, nicknameKey } from './nickname.ts'
import { hashOfPictures, tryFromElsewhere, tryOnOwnDevice } from './picture-tries.ts'
import { newSecret, pictures } from './pictures.ts'
import { addPupil, classToJoin, countPupils, pupilCalled, pupilOf, setHand } from './pupils-store.ts'
import { endSession, proveSession, readPupil, startSession } from './sessions-store.ts'
import { isHidden } from '../teaching/ending-store.ts'
import { triersOfCode, triersOfPictures } from './triers.ts'

/** A class of a school has up to 36 pupils. */
const mostPupils = 100

const short = v.pipe(v.string(), v.maxLength(100))
const threePictures = v.strictTuple([v.picklist(pictures), v.picklist(pictures), v.picklist(pictures)])

const clocked = ({ database, steady, secret }: Ports) => ({ db: database.db, now: steady(), secret })

/**
 * The class of a code. The right one always passes: whoever has guessed too often waits after a wrong one. A wrong one, a closed
 * one and one that never was are answered alike.
 */
async function classFor({ ports, triers, body }: Call<{ readonly code: string }>) {
  const key = codeKey(body.code) ?? ''
  const { codes, shortCodes } = ports.limits.guesses
  const guess = (isShortCode(key) ? shortCodes : codes).begin(triersOfCode(triers, ports.secret))
  // A code of no shape costs the same query.
  const found = await classToJoin(ports.database.db, key, ports.steady())
  if (found && !(await isHidden(ports, found))) {
    guess.right()
    return found
  }
  const seconds = guess.wrong()
  throw seconds === 0 ? new WrongTry(404, 'noOpenClass') : new WrongTry(429, 'tooManyTries', { seconds })
}

async function look(call: Call<{ readonly code: string }>): Promise<Answer> {
  const { name, language, grade } = await classFor(call)
  return { body: { name, language, grade } }
}

/** Adds a pupil who joins. @returns the token of its session @throws Refusal 409 where the class is full or has the nickname */
const added = (ports: Ports, row: NewPupil, device: string): Promise<string> =>
  ports.database.db.transaction().execute(async (inside) => {
    if ((await countPupils(inside, row.class)) >= mostPupils) throw new Refusal(409, 'classHasAll')
    if (!(await addPupil(inside, row))) throw new Refusal(409, 'nicknameTaken')
    await countJoin({ ...clocked(ports), db: inside }, device)
    return await startSession(inside, ports, row)
  })

async function join(call: Call<{ readonly code: string; readonly nickname: string }>): Promise<Answer> {
  const { ports, body, caller, triers } = call
  const { id: classId } = await classFor(call)
  const nickname = nicknameFrom(body.nickname)
  if (nickname === null) throw new Refusal(400, 'nickname')
  await refuseMoreJoins(clocked(ports), triers.device)
  const id = newToken(ports.random)
  const secret = newSecret(ports.random)
  const device = triers.device ?? newToken(ports.random)
  const row: NewPupil = {
    ...{ id, class: classId, nickname, nicknameKey: nicknameKey(nickname) },
    pictures: hashOfPictures(ports, id, secret),
    ...{ wrong: 0, lockedAt: null, handAt: null, isNew: 1, joinedAt: ports.now() },
  }
  // One after the other, and classes in turn: each waits for the disk.
  const turn = { class: classId, pupil: triers.device ?? caller.address }
  const token = await ports.limits.joins.run(turn, () => added(ports, row, device))
  ports.live.changed(classId, [id])
  const named = triers.device === null ? [cookie(deviceCookie, device, caller)] : []
  const cookies = [cookie(pupilCookie, token, caller), ...named]
  return { status: 201, body: { id, class: classId, nickname, pictures: secret }, cookies }
}

type Shown = v.InferOutput<typeof threePictures>

/** The session by which a device is known as this pupil's; null for any other device. */
async function sessionHere({ ports, headers }: Call<unknown>, pupil: string): Promise<string | null> {
  const token = cookieIn(headers, pupilCookie)
  const here = await readPupil(ports, token).catch(() => null)
  return here?.id === pupil ? here.session : null
}

async function comeBack(
  call: Call<{ readonly code: string; readonly nickname: string; readonly pictures: Shown }>,
): Promise<Answer> {
  const { ports, body, caller, triers } = call
  const { db } = ports.database
  const { id: classId } = await classFor(call)
  const key = nicknameKey(nicknameFrom(body.nickname) ?? '')
  const owner = await pupilCalled(db, classId, key)
  const session = owner ? await sessionHere(call, owner.id) : null
  if (owner && session !== null) await tryOnOwnDevice(ports, session, { owner, shown: body.pictures })
  else {
    const guess = ports.limits.guesses.pictures.begin(triersOfPictures(triers, ports.secret))
    await tryFromElsewhere(ports, { class: classId, key }, { owner, shown: body.pictures })
    guess.right()
  }
  // Pictures are never right for an unknown nickname.
  const { id, nickname } = owner!
  const token = await startSession(db, ports, owner!)
  return { body: { id, class: classId, nickname }, cookies: [cookie(pupilCookie, token, caller)] }
}

const me = async ({ ports, who }: Call<undefined>): Promise<Answer> => ({
  body: await liveOfPupil(ports, who.pupil!),
})

async function showPictures(call: Call<{ readonly pictures: Shown }>): Promise<Answer> {
  const { ports, who, body } = call
  const { db } = ports.database
  const { id, class: classId, session } = who.pupil!
  const owner = await pupilOf(db, classId, id)
  if (!owner) throw new Refusal(401, 'join')
  await tryOnOwnDevice(ports, session, { owner, shown: body.pictures })
  await proveSession(ports, session)
  return {}
}

async function leave({ ports, who, caller }: Call<undefined>): Promise<Answer> {
  await endSession(ports.database.db, who.pupil!.session)
  ports.live.end(who.pupil!.class, { pupil: who.pupil!.id }, 'signedOut')
  return { cookies: [cookie(pupilCookie, '', caller)] }
}

async function hand({ ports, who, body }: Call<{ readonly up: boolean }>): Promise<Answer> {
  const { id, class: classId } = who.pupil!
  ports.limits.hand(id)
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
