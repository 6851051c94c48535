import 'fake-indexeddb/auto'
import type { Project } from '@botgarten/programs'
import { deleteDB, openDB } from 'idb'
import { vi } from 'vitest'

/** Everything that a device holds, as data. */
export interface Device {
  readonly name: string
  readonly version: number
  readonly stores: {
    readonly projects: readonly DeviceRecord[]
    readonly bin: readonly (DeviceRecord & { readonly was: string; readonly thrown: number })[]
  }
  readonly localStorage: { readonly [name: string]: string }
}

interface DeviceRecord {
  readonly id: string
  readonly project: Project
  readonly changed: number
  readonly revision: number
}

/** A browser that nobody has used yet, and that keeps what it is given. */
export async function freshDevice(): Promise<void> {
  vi.restoreAllMocks()
  await deleteDB('botgarten')
}

/** A browser in a private window that keeps nothing. */
export async function deviceThatKeepsNothing(): Promise<void> {
  await freshDevice()
  vi.spyOn(indexedDB, 'open').mockImplementation(() => {
    throw new DOMException('Refused for a test.', 'SecurityError')
  })
}

/** From now on nothing more fits on the disk. Returns how to make room. */
export function fillDisk(): () => void {
  const put = vi.spyOn(IDBObjectStore.prototype, 'put').mockImplementation(() => {
    throw new DOMException('Full for a test.', 'QuotaExceededError')
  })
  return () => put.mockRestore()
}

/** A browser that holds these records, as the product of then has left them. */
export async function putDevice({ name, version, stores }: Pick<Device, 'name' | 'version' | 'stores'>) {
  await freshDevice()
  const db = await openDB(name, version, {
    upgrade: (made) =>
      Object.keys(stores).forEach((store) => made.createObjectStore(store, { keyPath: 'id' })),
  })
  for (const [store, records] of Object.entries(stores))
    for (const record of records) await db.put(store, record)
  db.close()
}

/** A device of the version before pictures had records of their own. */
export const putOldDevice = (projects: readonly unknown[], bin: readonly unknown[] = []) =>
  putDevice({ name: 'botgarten', version: 2, stores: { projects, bin } as unknown as Device['stores'] })

/** All keys of a store, as they are now. */
export async function keysIn(store: string): Promise<readonly IDBValidKey[]> {
  const db = await openDB('botgarten')
  const keys = await db.getAllKeys(store)
  db.close()
  return keys
}

/** A record as it lies there; with `value` it is replaced. */
export async function recordIn(store: string, key: IDBValidKey, value?: unknown): Promise<unknown> {
  const db = await openDB('botgarten')
  if (value !== undefined) await db.put(store, value)
  const record: unknown = await db.get(store, key)
  db.close()
  return record
}

/** A page of its own on this device: it shares nothing with other pages but what the browser shares. */
export async function openTab() {
  vi.resetModules()
  const [projects, bin, { Autosave }, { database }] = await Promise.all([
    import('../projects.ts'),
    import('../bin.ts'),
    import('../autosave.ts'),
    import('../database.ts'),
  ])
  return { ...projects, ...bin, Autosave, database }
}

/** Lets everything come that needs no clock, until this holds. */
export async function until(holds: () => boolean): Promise<void> {
  for (let turns = 0; !holds(); turns += 1) {
    if (turns > 5000) throw new Error('It did not come.')
    await new Promise((done) => setImmediate(done))
  }
}
