// Puts the storage of a browser of an earlier version into a new one, before the lab opens. e2e/samples.ts made the samples.
import { cpSync, mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import type { Page } from '@playwright/test'
import { openClassServer, startServer } from '../packages/server/index.ts'

interface Cookie {
  readonly name: string
  readonly value: string
  readonly domain: string
  readonly path: string
  readonly httpOnly: boolean
  readonly secure: boolean
  readonly sameSite: 'Lax'
}

export interface Profile {
  /** Of the pupil, by their English names. */
  readonly pictures: readonly string[]
  readonly cookies: readonly (Cookie & { readonly expires: number })[]
  readonly localStorage: { readonly [key: string]: string }
  readonly databases: readonly {
    readonly name: string
    readonly version: number
    readonly stores: readonly {
      readonly name: string
      readonly keyPath: string | string[]
      readonly records: readonly object[]
    }[]
  }[]
}

/** Addresses without their server, by kind. */
export interface Links {
  readonly [kind: string]: string
}

const samples = join(import.meta.dirname, 'samples')
/** Commits that have samples. */
export const earlierVersions = readdirSync(samples)

const read = (version: string, file: string): unknown =>
  JSON.parse(readFileSync(join(samples, version, file), 'utf8'))
export const profileOf = (version: string) => read(version, 'profile.json') as Profile
export const linksOf = (version: string) => read(version, 'links.json') as Links

const distantFuture = Date.UTC(2098, 0)

/** A server of this version on the class's data of an earlier one. Links with a date work again, and earlier lessons are over. */
export async function serverOfEarlier(version: string) {
  const data = mkdtempSync(join(tmpdir(), 'botgarten-earlier-'))
  cpSync(join(samples, version, 'class'), data, { recursive: true })
  const classServer = await openClassServer({ data })
  const { database, day } = classServer.ports
  const { db } = database
  await db.updateTable('pupilSession').set({ provenAt: 0 }).execute()
  await db.updateTable('class').set({ joiningUntil: distantFuture }).execute()
  await db.updateTable('invitation').set({ endsAt: distantFuture }).execute()
  await db
    .updateTable('substitute')
    .set({ day: day(0) })
    .execute()
  const server = await startServer({ port: 0, host: '127.0.0.1', classServer })
  return {
    ...server,
    classServer,
    async close() {
      await server.close()
      rmSync(data, { recursive: true, force: true })
    },
  }
}

/** Puts a profile into the browser, on an empty page of the server. The page then opens its address. */
export async function putProfile(page: Page, url: string, { cookies, localStorage, databases }: Profile) {
  await page.context().addCookies(cookies.map(({ expires: _, ...cookie }) => cookie))
  await page.route(`${url}/empty`, (route) => route.fulfill({ contentType: 'text/html', body: '' }))
  await page.goto(`${url}/empty`)
  await page.evaluate(
    async ([items, databases]) => {
      for (const [key, value] of Object.entries(items)) window.localStorage.setItem(key, value)
      for (const { name, version, stores } of databases)
        await new Promise<void>((resolve, reject) => {
          const request = indexedDB.open(name, version)
          request.onupgradeneeded = () => {
            for (const { name, keyPath, records } of stores) {
              const store = request.result.createObjectStore(name, { keyPath })
              for (const record of records) store.put(record)
            }
          }
          request.onerror = () => reject(request.error!)
          request.onsuccess = () => {
            request.result.close()
            resolve()
          }
        })
    },
    [localStorage, databases] as const,
  )
}
