import * as v from 'valibot'
import { nicknameFrom, nicknameKey } from '../joining/nickname.ts'
import { newSecret } from '../joining/pictures.ts'
import { isLocked, pupilOf, pupilsOf, rename, setHand, setPictures } from '../joining/pupils-store.ts'
import { forgetTriesAt, hashOfPictures, openLocks } from '../joining/picture-tries.ts'
import { endSessionsOf } from '../joining/sessions-store.ts'
import { projectsOf, versionOf } from '../projects/projects-store.ts'
import { Refusal } from '../refusal.ts'
import { route, type Answer, type Call, type Route } from '../route.ts'
import { allAbout } from './about-pupil.ts'
import { deleteForGood } from './deleting.ts'
import { streamed } from './streamed.ts'

/** The pupil that the path names, if it is one of the class. */
async function pupilIn({ ports, who, at }: Call<unknown>) {
  const pupil = await pupilOf(ports.database.db, who.class!.id, at['pupil']!)
  if (!pupil) throw new Refusal(404, 'noSuchPupil')
  return pupil
}

async function list({ ports, who }: Call<undefined>): Promise<Answer> {
  const pupils = await pupilsOf(ports.database.db, who.class!.id)
  const now = ports.now()
  const shown = pupils.map((pupil) => ({
    ...pupil,
    lockedAt: isLocked(pupil.lockedAt, now) ? pupil.lockedAt : null,
  }))
  return { body: { pupils: shown } }
}

async function change(call: Call<{ readonly nickname: string }>): Promise<Answer> {
  const pupil = await pupilIn(call)
  const nickname = nicknameFrom(call.body.nickname)
  if (nickname === null) throw new Refusal(400, 'nickname')
  if (!(await rename(call.ports.database.db, pupil, nickname, nicknameKey(nickname))))
    throw new Refusal(409, 'nicknameTaken')
  call.ports.live.changed(pupil.class, [pupil.id])
  return {}
}

async function remove(call: Call<undefined>): Promise<Answer> {
  const { id, class: classId } = await pupilIn(call)
  await deleteForGood(call.ports, { kind: 'pupil', id })
  call.ports.live.end(classId, { pupil: id }, 'removed')
  return {}
}

/** The teacher sees new pictures once, to show them to the pupil; other devices are signed out. */
async function newPictures(call: Call<undefined>): Promise<Answer> {
  const { ports } = call
  const { id, class: classId, nicknameKey: key } = await pupilIn(call)
  const secret = newSecret(ports.random)
  await setPictures(ports.database.db, id, hashOfPictures(ports, id, secret))
  await forgetTriesAt(ports, { class: classId, key })
  await endSessionsOf(ports.database.db, id)
  ports.live.end(classId, { pupil: id }, 'signedOut')
  return { body: { pictures: secret } }
}

/** Opens all locks of the class: one alone would show to others that this nickname exists. */
async function openAll({ ports, who }: Call<undefined>): Promise<Answer> {
  const { id } = who.class!
  if (!(await openLocks(ports, id))) throw new Refusal(409, 'opensUsedUp')
  ports.live.changed(id)
  return {}
}

/** Older pages open one lock at a time. */
async function openLock(call: Call<undefined>): Promise<Answer> {
  await pupilIn(call)
  return await openAll(call)
}

async function handDown(call: Call<undefined>): Promise<Answer> {
  const { id, class: classId } = await pupilIn(call)
  await setHand(call.ports.database.db, id, null)
  call.ports.live.changed(classId, [id])
  return {}
}

async function projects(call: Call<undefined>): Promise<Answer> {
  const { id } = await pupilIn(call)
  return { body: { projects: await projectsOf(call.ports.database.db, id) } }
}

/** Nobody reads a child's project unseen. */
async function project(call: Call<undefined>): Promise<Answer> {
  const { id, class: classId } = await pupilIn(call)
  call.ports.live.look(classId, id, call.who.teacher?.username ?? null, 15)
  const found = await versionOf(call.ports.database.db, id, call.at['project']!)
  if (!found) throw new Refusal(404, 'noSuchProject')
  return { body: found }
}

/** All about a pupil, for parents who ask. */
async function everything(call: Call<undefined>): Promise<Response> {
  const pupil = await pupilIn(call)
  const slot = call.ports.limits.exports.enter(call.who.teacher!.id)
  return streamed(allAbout(call.ports.database.db, pupil), pupil.nickname, slot)
}

const one = '/classes/:class/pupils/:pupil'

export const pupilRoutes: readonly Route[] = [
  route('GET', '/classes/:class/pupils', ['owner'], list),
  route('PATCH', one, ['owner'], change, v.strictObject({ nickname: v.pipe(v.string(), v.maxLength(100)) })),
  route('DELETE', one, ['owner'], remove),
  route('POST', `${one}/pictures`, ['owner'], newPictures),
  route('POST', '/classes/:class/unlock', ['owner'], openAll),
  route('POST', `${one}/unlock`, ['owner'], openLock),
  route('POST', `${one}/hand-down`, ['owner', 'substitute'], handDown),
  route('GET', `${one}/projects`, ['owner'], projects),
  route('GET', `${one}/projects/:project`, ['owner'], project),
  route('GET', `${one}/everything`, ['owner'], everything),
]
