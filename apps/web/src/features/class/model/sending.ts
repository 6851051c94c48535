import {
  nextToSend,
  nextToThrow,
  noteAnswer,
  noteNotThrown,
  noteThrownInClass,
  type Answered,
  type OutboxRecord,
} from '#storage/outbox.ts'
import { writeProject } from '@botgarten/programs/project'
import * as v from 'valibot'
import { read, type Ask, type Reply } from '#storage/ask.ts'

/**
 * Why nothing is sent now. `away`: the class cannot be reached · `full`: it has no more room · `trouble`: it cannot save ·
 * `slow`: too much was sent of late, and the rest follows ·
 * `signedOut`: the child has to show its pictures again · `otherPupil`: somebody else is signed in here · `ended`: the class
 * is no more · `hidden`: it has ended by the date of the server and is not deleted yet.
 */
export type Pause = 'away' | 'full' | 'trouble' | 'slow' | 'signedOut' | 'otherPupil' | 'ended' | 'hidden'

/** In the class every pupil has a space of their own; ids there are at least eight letters long. */
const prefix = 'project-'
export const idInClass = (id: string): string => `${prefix}${id}`
export const idOnDevice = (id: string): string | null =>
  id.startsWith(prefix) ? id.slice(prefix.length) : null

export const mark = v.nullable(v.string())
const saved = v.object({ revision: v.pipe(v.number(), v.integer(), v.minValue(1)), hash: v.string(), mark })
const thrown = v.object({ mark })

/** What a project itself is refused for: waiting would change nothing. */
const ownFault: readonly number[] = [400, 413, 415, 422]

const pauses: { readonly [code: string]: Pause } = {
  join: 'signedOut',
  showPictures: 'signedOut',
  otherPupil: 'otherPupil',
  classEnded: 'ended',
  classHidden: 'hidden',
  classFull: 'full',
  tooFast: 'slow',
  classTooFast: 'slow',
  tooMuchAtOnce: 'slow',
}

export const pauseOf = (reply: Reply): Pause =>
  reply.kind === 'refused' ? (pauses[reply.code] ?? 'trouble') : 'away'

/** What an answer means for the save that was sent; or why it waits. */
function meaningOf(reply: Reply): Answered | Pause {
  const found = read(saved, reply)
  if (found) return { kind: 'saved', ...found }
  if (reply.kind !== 'refused') return 'away'
  const { status, code, facts } = reply
  if (code === 'newerRevision')
    return facts.revision
      ? { kind: 'conflict', revision: facts.revision, hash: facts.hash ?? '' }
      : { kind: 'gone' }
  if (ownFault.includes(status)) return { kind: 'refused', reason: facts.reason ?? code }
  return pauseOf(reply)
}

/** The version of the class that a request is based on. */
const ontoOf = (base: number, hash: string | undefined) =>
  `base=${base}${hash === undefined ? '' : `&onto=${hash}`}`

async function send(ask: Ask, record: OutboxRecord): Promise<Pause | null> {
  const { id, save, base, hash, project } = record
  const path = `/projects/${idInClass(id)}?${ontoOf(base, hash)}&save=${save}`
  const meaning = meaningOf(await ask('PUT', path, writeProject(project)))
  if (typeof meaning === 'string') return meaning
  await noteAnswer(record, meaning)
  return null
}

/** Sends one save. @returns whether there was one, or why it waits */
export async function sendNext(ask: Ask): Promise<'sent' | 'none' | Pause> {
  const next = await nextToSend()
  return next ? ((await send(ask, next)) ?? 'sent') : 'none'
}

/** Has one project thrown away in the class that was thrown away here. @returns as `sendNext` */
async function throwNext(ask: Ask): Promise<'sent' | 'none' | Pause> {
  const next = await nextToThrow()
  if (!next) return 'none'
  const { id, base, hash } = next
  // What never came to the class is nowhere.
  if (base === 0) return (await noteThrownInClass(id), 'sent')
  const reply = await ask('DELETE', `/projects/${idInClass(id)}?${ontoOf(base, hash)}`)
  if (reply.kind === 'refused' && reply.code === 'newerRevision') {
    const { revision = 0, hash: has = '' } = reply.facts
    return (await noteNotThrown(id, { revision, hash: has }), 'sent')
  }
  const isGone = reply.kind === 'refused' && reply.code === 'noSuchProject'
  if (reply.kind !== 'done' && !isGone) return pauseOf(reply)
  await noteThrownInClass(id, read(thrown, reply)?.mark)
  return 'sent'
}

async function all(next: (ask: Ask) => Promise<'sent' | 'none' | Pause>, ask: Ask): Promise<Pause | null> {
  for (;;) {
    const outcome = await next(ask)
    if (outcome === 'none') return null
    if (outcome !== 'sent') return outcome
  }
}

/** Sends all that waits. @returns why something still waits; null where the class has all that it can have */
export const sendAll = async (ask: Ask): Promise<Pause | null> =>
  (await all(sendNext, ask)) ?? (await all(throwNext, ask))
