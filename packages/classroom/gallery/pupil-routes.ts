import * as v from 'valibot'
import { newToken } from '../hashes.ts'
import { NoRoom } from '../projects/room-store.ts'
import { deviceId, wholeNumber } from '../projects/routes.ts'
import type { Ports } from '../ports.ts'
import { Refusal } from '../refusal.ts'
import { route, type Answer, type Call, type Route } from '../route.ts'
import { classById } from '../teaching/classes-store.ts'
import {
  addShared,
  countShared,
  removeShared,
  sentBefore,
  setHeart,
  sharedIn,
  sharedOne,
  type Order,
  type Viewer,
} from './shared-store.ts'
import { shownOne, shownRows } from './shown.ts'
import { snapshotOf } from './snapshot.ts'
import { titleFrom } from './title.ts'

/** So many things a pupil has in the gallery at the most. */
const mostShared = 100

const noSuchShared = () => new Refusal(404, 'noSuchShared')

/** Who looks. @throws Refusal where the teacher has switched the gallery off */
async function viewerOf({ ports, who }: Call<unknown>): Promise<Viewer> {
  const { id: pupil, class: classId } = who.pupil!
  const row = await classById(ports.database.db, classId)
  if (row?.gallery !== 1) throw new Refusal(403, 'galleryOff')
  return { class: classId, pupil }
}

/** Pages that show the gallery look again. */
export const tellClass = ({ live }: Ports, classId: string): void => live.tell(classId, null, 'gallery', {})

/** The page of the gallery that was asked for. */
export async function pageOf({ ports, query }: Call<unknown>, viewer: Viewer, orders: readonly Order[]) {
  const { db } = ports.database
  const order = orders.find((one) => one === (query.get('by') ?? orders[0]))
  if (order === undefined) throw new Refusal(400, 'notUnderstood')
  const rows = await sharedIn(db, viewer, order, wholeNumber(query.get('from') ?? '0'))
  return { total: await countShared(db, viewer, order), items: await shownRows(db, viewer, rows) }
}

export async function oneOf({ ports, at }: Call<unknown>, viewer: Viewer): Promise<Answer> {
  const { db } = ports.database
  const row = await sharedOne(db, viewer, at['shared']!)
  if (!row) throw noSuchShared()
  return { body: await shownOne(db, viewer, row) }
}

const list = async (call: Call<undefined>): Promise<Answer> => ({
  body: await pageOf(call, await viewerOf(call), ['newest', 'hearts', 'mine']),
})

const look = async (call: Call<undefined>): Promise<Answer> => oneOf(call, await viewerOf(call))

/** A snapshot; its title is the project's name. One that shows a photo of its own waits for the teacher. */
async function share(call: Call<string>): Promise<Answer> {
  const { ports, query, body } = call
  const viewer = await viewerOf(call)
  const sent = deviceId(query.get('share'))
  const checked = await ports.checkProject(body, { class: viewer.class, pupil: viewer.pupil! })
  if ('refused' in checked) throw new Refusal(422, 'projectRefused', { reason: checked.refused })
  const title = titleFrom(checked.name)
  if (title === null) throw new Refusal(400, 'title')
  const { chain, ...snapshot } = snapshotOf(checked)
  const row = {
    ...{ id: newToken(ports.random), class: viewer.class, pupil: viewer.pupil!, sent, title },
    ...{ card: checked.card, at: ports.now(), bytes: Buffer.byteLength(snapshot.document) },
    ...snapshot,
    chain: JSON.stringify(chain),
    hidden: 0 as const,
    waiting: checked.assets.length > 0 ? (1 as const) : (0 as const),
  }
  const answer = await keep(call, viewer, row, checked.assets)
  tellClass(ports, viewer.class)
  return { status: 201, body: answer }
}

function keep(
  { ports }: Call<unknown>,
  viewer: Viewer,
  row: Parameters<typeof addShared>[1],
  assets: Parameters<typeof addShared>[2],
) {
  return ports.database.db
    .transaction()
    .execute(async (inside) => {
      const before = await sentBefore(inside, row.pupil, row.sent)
      if (before) return { id: before.id, waiting: before.waiting === 1 }
      if ((await countShared(inside, viewer, 'mine')) >= mostShared) throw new Refusal(409, 'galleryFull')
      await addShared(inside, row, assets)
      return { id: row.id, waiting: row.waiting === 1 }
    })
    .catch((error: unknown) => {
      if (!(error instanceof NoRoom)) throw error
      throw new Refusal(error.full === 'classFull' ? 507 : 409, error.full)
    })
}

/** Also where the gallery is off: what is one's own can always be taken back. */
async function remove({ ports, who, at }: Call<undefined>): Promise<Answer> {
  const { id: pupil, class: classId } = who.pupil!
  if (!(await removeShared(ports.database.db, { class: classId, pupil }, at['shared']!))) throw noSuchShared()
  tellClass(ports, classId)
  return {}
}

async function heart(call: Call<{ readonly on: boolean }>): Promise<Answer> {
  const { ports, at, body } = call
  const { db } = ports.database
  const viewer = await viewerOf(call)
  const row = await sharedOne(db, viewer, at['shared']!)
  if (!row) throw noSuchShared()
  if (row.pupil === viewer.pupil) throw new Refusal(409, 'ownShared')
  ports.limits.heart(viewer.pupil!)
  await setHeart(db, row.id, viewer.pupil!, body.on)
  tellClass(ports, viewer.class)
  const now = await sharedOne(db, viewer, row.id)
  return { body: { hearts: now?.hearts ?? 0, mine: body.on } }
}

export const galleryPupilRoutes: readonly Route[] = [
  route('GET', '/gallery', ['pupil'], list),
  route('POST', '/gallery', ['pupil'], share, 'project'),
  route('GET', '/gallery/:shared', ['pupil'], look),
  route('DELETE', '/gallery/:shared', ['pupil'], remove),
  route('PUT', '/gallery/:shared/heart', ['pupil'], heart, v.strictObject({ on: v.boolean() })),
]
