import * as v from 'valibot'
import { Refusal } from '../refusal.ts'
import { route, type Answer, type Call, type Route } from '../route.ts'
import { changeClass } from '../teaching/classes-store.ts'
import { clearQuestions } from '../asking/peers-store.ts'
import { endPairs } from '../together/pairs-store.ts'
import { oneOf, pageOf, tellClass } from './pupil-routes.ts'
import { changeShared, countShared, type Viewer } from './shared-store.ts'

const viewerOf = ({ who }: Call<unknown>): Viewer => ({ class: who.class!.id, pupil: null })

async function list(call: Call<undefined>): Promise<Answer> {
  const viewer = viewerOf(call)
  const { gallery, asking, together } = call.who.class!
  const waiting = await countShared(call.ports.database.db, viewer, 'waiting')
  const page = await pageOf(call, viewer, ['newest', 'hearts', 'waiting', 'hidden'])
  const on = { on: gallery === 1, asking: asking === 1, together: together === 1 }
  return { body: { ...on, waiting, ...page } }
}

const look = (call: Call<undefined>): Promise<Answer> => oneOf(call, viewerOf(call))

const settings = v.partial(v.strictObject({ on: v.boolean(), asking: v.boolean(), together: v.boolean() }))

const bit = (is: boolean) => (is ? (1 as const) : (0 as const))

/** Whether there is a gallery, whether pupils may ask each other, and whether two may work on one program. */
async function set({ ports, who, body }: Call<v.InferOutput<typeof settings>>): Promise<Answer> {
  const { id } = who.class!
  const { on, asking, together } = body
  const change = {
    ...(on !== undefined && { gallery: bit(on) }),
    ...(asking !== undefined && { asking: bit(asking) }),
    ...(together !== undefined && { together: bit(together) }),
  }
  if (Object.keys(change).length > 0) await changeClass(ports.database.db, id, change)
  if (asking === false) await clearQuestions(ports.database.db, id)
  if (together === false) await endPairs(ports.database.db, id)
  ports.live.changed(id)
  return {}
}

const decision = v.partial(v.strictObject({ hidden: v.boolean(), allowed: v.literal(true) }))

/** Puts something out of sight or back, or agrees to its photo. */
async function decide({ ports, who, at, body }: Call<v.InferOutput<typeof decision>>): Promise<Answer> {
  const { hidden, allowed } = body
  const change = {
    ...(hidden !== undefined && { hidden: bit(hidden) }),
    ...(allowed && { waiting: 0 as const }),
  }
  if (Object.keys(change).length === 0) throw new Refusal(400, 'notUnderstood')
  if (!(await changeShared(ports.database.db, who.class!.id, at['shared']!, change)))
    throw new Refusal(404, 'noSuchShared')
  tellClass(ports, who.class!.id)
  return {}
}

const gallery = '/classes/:class/gallery'

export const galleryTeacherRoutes: readonly Route[] = [
  route('GET', gallery, ['owner'], list),
  route('PUT', gallery, ['owner'], set, settings),
  route('GET', `${gallery}/:shared`, ['owner'], look),
  route('PUT', `${gallery}/:shared`, ['owner'], decide, decision),
]
