import { newToken } from '../hashes.ts'
import { Refusal } from '../refusal.ts'
import { route, type Answer, type Call, type Route } from '../route.ts'
import { knowsMark, markOf } from './marks-store.ts'
import { deleteProject, projectsOf, textOfVersion, thrownOf, versionsOf } from './projects-store.ts'
import { mostProjects } from './saves-store.ts'
import { mostSpace } from './space-store.ts'

/** Ids are made on devices; each pupil has a space of their own. */
const idOfDevice = /^[\w-]{8,64}$/

export function wholeNumber(text: string | null | undefined): number {
  if (text === null || text === undefined || !/^\d{1,9}$/.test(text)) throw new Refusal(400, 'notUnderstood')
  return Number(text)
}

export function deviceId(text: string | null | undefined): string {
  if (!idOfDevice.test(text ?? '')) throw new Refusal(400, 'notUnderstood')
  return text!
}

/** The class has another version than the one that the device knows. */
const anotherVersion = ({ revision, hash }: { readonly revision: number; readonly hash?: string }) =>
  new Refusal(409, 'newerRevision', { revision, ...(hash !== undefined && { hash }) })

async function list({ ports, who, query }: Call<undefined>): Promise<Answer> {
  const { db } = ports.database
  const { id } = who.pupil!
  const bin = await thrownOf(db, id)
  const seen = query.get('mark')
  return {
    body: {
      projects: await projectsOf(db, id),
      bin,
      // For pages that were loaded before `bin` existed.
      thrown: bin.map((one) => one.id),
      mark: await markOf(db, id),
      // Whether the class has everything that this device saw; it has not where it was restored since.
      known: seen === null || (await knowsMark(db, id, seen)),
    },
  }
}

/** The whole of it or nothing: what is answered 200 is on the disk. */
async function save({ ports, who, at, query, body }: Call<string>): Promise<Answer> {
  const { id: pupil, class: classId } = who.pupil!
  const [project, saveId] = [deviceId(at['project']), deviceId(query.get('save'))]
  const base = wholeNumber(query.get('base'))
  const checked = await ports.checkProject(body, { class: classId, pupil })
  if ('refused' in checked) throw new Refusal(422, 'projectRefused', { reason: checked.refused })
  const onto = query.get('onto') ?? undefined
  const key = { pupil, class: classId, project, save: saveId, base, onto }
  const saved = await ports.save({
    ...key,
    checked,
    at: ports.now(),
    steady: ports.steady(),
    random: newToken(ports.random),
  })
  if (saved.kind === 'conflict') throw anotherVersion(saved)
  if (saved.kind === 'tooManyProjects')
    throw new Refusal(422, 'projectRefused', { reason: saved.kind, most: mostProjects })
  if (saved.kind === 'pupilFull')
    throw new Refusal(422, 'projectRefused', { reason: saved.kind, most: mostSpace.pupil })
  if (saved.kind === 'classFull') throw new Refusal(507, 'classFull')
  const { revision, mark, space } = saved
  return { body: { revision, hash: checked.hash, mark, full: space >= mostSpace.class * 0.8 } }
}

/** A version as it is stored: a large one is not taken apart and put together again. */
async function shown({ ports, who, at }: Call<undefined>, revision?: number): Promise<Response> {
  const text = await textOfVersion(ports.database.db, who.pupil!.id, at['project']!, revision)
  if (text === null) throw new Refusal(404, 'noSuchProject')
  return new Response(text, { headers: { 'content-type': 'application/json; charset=utf-8' } })
}

const read = (call: Call<undefined>): Promise<Response> => shown(call)

async function versions({ ports, who, at }: Call<undefined>): Promise<Answer> {
  return { body: { versions: await versionsOf(ports.database.db, who.pupil!.id, at['project']!) } }
}

const version = async (call: Call<undefined>): Promise<Response> =>
  await shown(call, wholeNumber(call.at['revision']))

async function remove({ ports, who, at, query }: Call<undefined>): Promise<Answer> {
  const { id, class: classId } = who.pupil!
  const base = { revision: wholeNumber(query.get('base')), hash: query.get('onto') ?? undefined }
  const { db } = ports.database
  const of = { pupil: id, class: classId }
  const outcome = await deleteProject(db, of, at['project']!, base, newToken(ports.random))
  if (outcome === null) throw new Refusal(404, 'noSuchProject')
  if ('revision' in outcome) throw anotherVersion(outcome)
  return { body: outcome }
}

export const projectRoutes: readonly Route[] = [
  route('GET', '/projects', ['pupil'], list),
  // An outbox may be emptied after the lesson: work is taken in before the pictures are shown, and nothing is read.
  route('PUT', '/projects/:project', ['pupil', 'returning'], save, 'project'),
  route('GET', '/projects/:project', ['pupil'], read),
  route('DELETE', '/projects/:project', ['pupil'], remove),
  route('GET', '/projects/:project/versions', ['pupil'], versions),
  route('GET', '/projects/:project/versions/:revision', ['pupil'], version),
]
