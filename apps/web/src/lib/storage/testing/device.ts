import 'fake-indexeddb/auto'
import { IDBFactory } from 'fake-indexeddb'
import type { Project } from '@botgarten/programs'
import { openDB } from 'idb'
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

/** A browser that holds these records, and a page that has just been opened there. */
export async function putDevice({ name, version, stores }: Device) {
  vi.stubGlobal('indexedDB', new IDBFactory())
  const db = await openDB(name, version, {
    upgrade: (made) =>
      Object.keys(stores).forEach((store) => made.createObjectStore(store, { keyPath: 'id' })),
  })
  for (const [store, records] of Object.entries(stores))
    for (const record of records) await db.put(store, record)
  db.close()
  vi.resetModules()
  const [{ list, load }, { listBin }] = await Promise.all([import('../projects.ts'), import('../bin.ts')])
  return { list, load, listBin }
}
