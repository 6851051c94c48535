import * as v from 'valibot'
import { readPupil } from '../joining/sessions-store.ts'
import { cookieIn, pupilCookie } from '../joining/cookies.ts'
import { Refusal } from '../refusal.ts'
import { route, type Answer, type Call, type Route } from '../route.ts'
import { documentOf, putAway } from './handouts-store.ts'
import { liveOfPupil } from './me-live.ts'
import { here } from './schema.ts'

/** Events of a pupil's page: its complete state whenever that is another. One a browser, shared by its pages. */
function stream({ ports, who, headers }: Call<undefined>): Promise<Response> {
  const { id, class: classId } = who.pupil!
  const token = cookieIn(headers, pupilCookie)
  async function read() {
    try {
      const pupil = await readPupil(ports, token)
      return pupil?.fresh ? await liveOfPupil(ports, pupil) : null
    } catch (error) {
      if (error instanceof Refusal) return null
      throw error
    }
  }
  const closed = ports.limits.stream({ id, class: classId })
  return Promise.resolve(ports.live.open({ class: classId, pupil: id, teacher: null, read, closed }))
}

function report({ ports, who, body }: Call<v.InferOutput<typeof here>>): Promise<Answer> {
  ports.live.report(who.pupil!.class, who.pupil!.id, body)
  return Promise.resolve({})
}

async function program({ ports, who, at }: Call<undefined>): Promise<Answer> {
  const document = await documentOf(ports.database.db, who.pupil!.id, at['handout']!)
  if (document === undefined) throw new Refusal(404, 'noSuchHandout')
  return { body: { project: document === null ? null : (JSON.parse(document) as unknown) } }
}

async function away({ ports, who, at }: Call<undefined>): Promise<Answer> {
  const { id, class: classId } = who.pupil!
  if (!(await putAway(ports.database.db, id, at['handout']!))) throw new Refusal(404, 'noSuchHandout')
  ports.live.changed(classId, [id])
  return {}
}

export const livePupilRoutes: readonly Route[] = [
  route('GET', '/me/stream', ['pupil'], stream),
  route('PUT', '/me/here', ['pupil'], report, here),
  route('GET', '/me/handouts/:handout', ['pupil'], program),
  route('DELETE', '/me/handouts/:handout', ['pupil'], away),
]
