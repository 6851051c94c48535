import { Refusal } from '../refusal.ts'
import { route, type Answer, type Call, type Route } from '../route.ts'
import { deleteProject, projectsOf, thrownOf, versionOf, versionsOf } from './projects-store.ts'
import { mostSpace } from './saves-store.ts'

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

async function list({ ports, who }: Call<undefined>): Promise<Answer> {
  const { db } = ports.database
  const { id } = who.pupil!
  return { body: { projects: await projectsOf(db, id), thrown: await thrownOf(db, id) } }
}

/** The whole of it or nothing: what is answered 200 is on the disk. */
async function save({ ports, who, at, query, body }: Call<string>): Promise<Answer> {
  const { id: pupil, class: classId } = who.pupil!
  const [project, saveId] = [deviceId(at['project']), deviceId(query.get('save'))]
  const base = wholeNumber(query.get('base'))
  const checked = await ports.checkProject(body)
  if ('refused' in checked) throw new Refusal(422, 'projectRefused', { reason: checked.refused })
  const all = { pupil, class: classId, project, save: saveId, base, checked, at: ports.now() }
  const saved = await ports.save(all)
  if (saved.kind === 'conflict') throw new Refusal(409, 'newerRevision', { revision: saved.revision })
  if (saved.kind === 'classFull') throw new Refusal(507, 'classFull')
  return { body: { revision: saved.revision, full: saved.space >= mostSpace * 0.8 } }
}

async function read({ ports, who, at }: Call<undefined>): Promise<Answer> {
  const found = await versionOf(ports.database.db, who.pupil!.id, at['project']!)
  if (!found) throw new Refusal(404, 'noSuchProject')
  return { body: found }
}

async function versions({ ports, who, at }: Call<undefined>): Promise<Answer> {
  return { body: { versions: await versionsOf(ports.database.db, who.pupil!.id, at['project']!) } }
}

async function version({ ports, who, at }: Call<undefined>): Promise<Answer> {
  const found = await versionOf(ports.database.db, who.pupil!.id, at['project']!, wholeNumber(at['revision']))
  if (!found) throw new Refusal(404, 'noSuchProject')
  return { body: found }
}

async function remove({ ports, who, at, query }: Call<undefined>): Promise<Answer> {
  const { id, class: classId } = who.pupil!
  const base = wholeNumber(query.get('base'))
  const outcome = await deleteProject(ports.database.db, id, classId, at['project']!, base)
  if (outcome === null) throw new Refusal(404, 'noSuchProject')
  if (outcome !== 'deleted') throw new Refusal(409, 'newerRevision', { revision: outcome })
  return {}
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
