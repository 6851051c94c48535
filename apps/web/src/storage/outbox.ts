// What is on its way to the class. Nothing has to be noted when a project is saved: whatever the device holds in another
// revision than the class has to be sent, however the page ended.
import type { Project } from '@botgarten/programs/project'
import {
  reading,
  storageErrorIn,
  tried,
  writing,
  type ClassVersion,
  type OutboxRecord,
  type Reading,
  type StorageError,
  type SyncRecord,
  type Writing,
} from './database.ts'
import { freshId, type Listed } from './projects.ts'
import { isBehind, noteMark, basedOn, unknown } from './class-versions.ts'
import { firstRevision, getProject, putProject, savedRevision } from './records.ts'

export type { OutboxRecord } from './database.ts'

/** Where a project is. `waiting`: on this device alone, or with changes that the class does not have yet. */
export type Whereabouts =
  /** The class has this revision of the device. */
  | { readonly kind: 'class'; readonly revision: number }
  | { readonly kind: 'waiting' }
  | { readonly kind: 'conflict'; readonly revision: number }
  | { readonly kind: 'refused'; readonly reason: string }

export type AllWhereabouts = ReadonlyMap<string, Whereabouts>

function whereIs(revision: number, sync: SyncRecord | undefined, isOnItsWay: boolean): Whereabouts {
  const { conflict, refused, synced = 0 } = sync ?? {}
  if (conflict !== undefined) return { kind: 'conflict', revision: conflict }
  if (isOnItsWay) return { kind: 'waiting' }
  if (revision === synced) return { kind: 'class', revision }
  if (refused?.revision === revision) return { kind: 'refused', reason: refused.reason }
  return { kind: 'waiting' }
}

async function whereaboutsIn(transaction: Reading | Writing): Promise<AllWhereabouts> {
  const revisions = await transaction.objectStore('revisions').getAll()
  const syncs = new Map((await transaction.objectStore('sync').getAll()).map((one) => [one.id, one]))
  const sending = new Set(await transaction.objectStore('outbox').getAllKeys())
  return new Map(
    revisions.map(({ id, revision }) => [id, whereIs(revision, syncs.get(id), sending.has(id))] as const),
  )
}

/** Where every project of this device is; empty where the device cannot be read. */
export async function whereabouts(): Promise<AllWhereabouts> {
  try {
    return await reading(whereaboutsIn)
  } catch (cause) {
    console.warn('The device does not say what waits for the class.', cause)
    return new Map()
  }
}

/** The save to be sent next, the one that was begun first; null where all is in the class. Begun again, it is saved first. */
export async function nextToSend(): Promise<OutboxRecord | null> {
  return writing(async (transaction) => {
    const [begun] = await transaction.objectStore('outbox').getAll(null, 1)
    if (begun) return begun
    const all = await whereaboutsIn(transaction)
    for (const [id, { kind }] of all) if (kind === 'waiting') return begin(transaction, id)
    return null
  })
}

async function begin(transaction: Writing, id: string): Promise<OutboxRecord | null> {
  const found = await getProject(transaction, id)
  if (!found) return null
  const { base, hash } = (await transaction.objectStore('sync').get(id)) ?? unknown(id)
  const record = { id, save: freshId('save'), revision: found.revision, base, hash, project: found.project }
  await keepFromThrowing(transaction, id)
  await transaction.objectStore('outbox').put(record)
  return record
}

/** Something has the place again of what was thrown away: it goes on from there. */
async function keepFromThrowing(transaction: Writing, id: string): Promise<void> {
  const { thrown, gone, ...sync } = (await transaction.objectStore('sync').get(id)) ?? unknown(id)
  if (thrown || gone) await transaction.objectStore('sync').put(sync)
}

/** A project that is deleted on this device but not in the class: its id, and the version of the class that is meant. */
export async function nextToThrow(): Promise<Pick<SyncRecord, 'id' | 'base' | 'hash'> | null> {
  return reading(async (transaction) => {
    for (const { id, base, hash, thrown } of await transaction.objectStore('sync').getAll()) {
      if (!thrown || (await transaction.objectStore('outbox').getKey(id))) continue
      if ((await savedRevision(transaction, id)) === null) return { id, base, hash }
    }
    return null
  })
}

/** The class has deleted it. The version is remembered: after a restore the class deletes it again. */
export async function noteThrownInClass(id: string, mark: string | null = null): Promise<void> {
  await writing(async (transaction) => {
    const sync = await transaction.objectStore('sync').get(id)
    if (!sync?.thrown) return
    const { base: revision, hash } = sync
    // Whatever has its place by now is new to the class.
    if (revision === 0) await transaction.objectStore('sync').delete(id)
    else await transaction.objectStore('sync').put({ id, base: 0, synced: 0, gone: { revision, hash } })
    await retryRefused(transaction, ['tooManyProjects', 'pupilFull'])
    await noteMark(transaction, mark)
  })
}

/** Projects that the class refused for one of these reasons are sent again. */
async function retryRefused(transaction: Writing, reasons: readonly string[]): Promise<void> {
  for (const { refused, ...sync } of await transaction.objectStore('sync').getAll())
    if (refused && reasons.includes(refused.reason)) await transaction.objectStore('sync').put(sync)
}

/** The class has another version than the deleted one: an older one, which is deleted too, or newer work, which is loaded again. */
export async function noteNotThrown(id: string, has: ClassVersion): Promise<void> {
  await writing(async (transaction) => {
    const sync = await transaction.objectStore('sync').get(id)
    if (!sync?.thrown) return
    if (isBehind(sync, has))
      await transaction.objectStore('sync').put({ ...basedOn(sync, has, 0), thrown: true })
    else await transaction.objectStore('sync').delete(id)
  })
}

/** Another device has thrown it away: it goes into the bin here too, unless there is work that the class does not have. */
export async function isThrownElsewhere(id: string): Promise<boolean> {
  return reading(async (transaction) => {
    const own = await savedRevision(transaction, id)
    const sync = await transaction.objectStore('sync').get(id)
    const isOnItsWay = (await transaction.objectStore('outbox').getKey(id)) !== undefined
    if (own === null || isOnItsWay || sync === undefined || sync.conflict !== undefined) return false
    return sync.base > 0 && own === sync.synced
  })
}

/** What the class has answered to a save. `gone`: it has no such project any more, this one is new to it. */
export type Answered =
  | ({ readonly kind: 'saved'; readonly mark: string | null } & ClassVersion)
  | ({ readonly kind: 'conflict' } & ClassVersion)
  | { readonly kind: 'gone' }
  | { readonly kind: 'refused'; readonly reason: string }

/** Takes a save out of the outbox that the class has answered. An answer that comes twice changes nothing. */
export async function noteAnswer({ id, save }: OutboxRecord, answer: Answered): Promise<void> {
  await writing(async (transaction) => {
    const waiting = await transaction.objectStore('outbox').get(id)
    if (waiting?.save !== save) return
    await transaction.objectStore('outbox').delete(id)
    const before = (await transaction.objectStore('sync').get(id)) ?? unknown(id)
    await transaction.objectStore('sync').put(syncAfter(before, waiting, answer))
    if (answer.kind === 'saved') await noteMark(transaction, answer.mark)
  })
}

function syncAfter(before: SyncRecord, sent: OutboxRecord, answer: Answered): SyncRecord {
  const { id, base, hash, seen, synced, thrown } = before
  switch (answer.kind) {
    case 'saved':
      return { ...basedOn(before, answer, sent.revision), ...(thrown && { thrown }) }
    case 'conflict':
      // The class was restored to a version that this work was made from.
      if (isBehind(before, answer)) return basedOn(before, answer, 0)
      return { id, base, hash, seen, synced, conflict: answer.revision }
    case 'gone':
      return { ...unknown(id), seen }
    case 'refused':
      return { id, base, hash, seen, synced, refused: { revision: sent.revision, reason: answer.reason } }
  }
}

/** A project as the class has it. */
export interface FromClass extends ClassVersion {
  readonly id: string
  readonly savedAt: number
  readonly project: Project
}

/** How this device stands to a revision of the class: `new` here, `older` here and unchanged, or nothing to be done. */
export async function isWanted(id: string, revision: number): Promise<boolean> {
  return reading(async (transaction) => {
    const own = await savedRevision(transaction, id)
    const sync = (await transaction.objectStore('sync').get(id)) ?? unknown(id)
    if (sync.conflict !== undefined || (await transaction.objectStore('outbox').getKey(id))) return false
    return own === null ? !sync.thrown : own === sync.synced && sync.base < revision
  })
}

/** Puts a project of the class on the device, unless there is work here that the class does not have. */
export async function takeIn(fromClass: FromClass): Promise<void> {
  const { id, savedAt, project } = fromClass
  await tried(async (transaction) => {
    const own = await savedRevision(transaction, id)
    const sync = (await transaction.objectStore('sync').get(id)) ?? unknown(id)
    const isOnItsWay = (await transaction.objectStore('outbox').getKey(id)) !== undefined
    const isLeft = isOnItsWay || sync.conflict !== undefined
    if (isLeft || (own === null ? sync.thrown : own !== sync.synced)) return
    const next = own === null ? firstRevision() : own + 1
    await putProject(transaction, { id, project, changed: savedAt, revision: next })
    await transaction.objectStore('sync').put(basedOn(sync, fromClass, next))
  })
}

/** Both are kept: this device's goes on, and the class's gets a place of its own. */
export async function goOnWithOwn(fromClass: FromClass, copy: Listed): Promise<StorageError | null> {
  const { id } = fromClass
  return storageErrorIn(async (transaction) => {
    await putProject(transaction, { ...copy, revision: firstRevision() })
    const sync = (await transaction.objectStore('sync').get(id)) ?? unknown(id)
    await transaction.objectStore('outbox').delete(id)
    // Not even an unchanged project is in the class: its newest version is the other one.
    await transaction.objectStore('sync').put(basedOn(sync, fromClass, 0))
  })
}

/** Both are kept: the class's goes on, and this device's, as it stands when this is asked, gets a place of its own. */
export async function goOnWithClass(
  fromClass: FromClass,
  copyOf: (own: Project) => Listed,
): Promise<StorageError | null> {
  const { id, savedAt, project } = fromClass
  return storageErrorIn(async (transaction) => {
    const own = await getProject(transaction, id)
    if (own) await putProject(transaction, { ...copyOf(own.project), revision: firstRevision() })
    const next = own ? own.revision + 1 : firstRevision()
    await putProject(transaction, { id, project, changed: savedAt, revision: next })
    const sync = (await transaction.objectStore('sync').get(id)) ?? unknown(id)
    await transaction.objectStore('outbox').delete(id)
    await transaction.objectStore('sync').put(basedOn(sync, fromClass, next))
  })
}

/** An older version comes back as the newest one: it is a change like any other. */
export async function takeVersionBack(id: string, project: Project): Promise<StorageError | null> {
  return storageErrorIn(async (transaction) => {
    const revision = ((await savedRevision(transaction, id)) ?? firstRevision()) + 1
    await putProject(transaction, { id, project, changed: Date.now(), revision })
  })
}
