import { randomBytes } from 'node:crypto'
import { createReadStream, statfsSync, statSync } from 'node:fs'
import { basename } from 'node:path'
import { Readable } from 'node:stream'
import {
  accountsOn,
  Hub,
  Limits,
  noBus,
  lastBackup,
  nightlyBackup,
  nightliesIn,
  otherCopiesIn,
  type Bus,
  bury,
  checkInWorker,
  saveQueueOn,
  useReserve,
  type Database,
  type Host,
  type LogLine,
  type Ports,
} from '@botgarten/classroom'
import root from '../../package.json' with { type: 'json' }
import { announcedTo } from './announced.ts'
import { cardsInWorker, questionnairesInWorker } from './content.ts'
import { examineRunning } from './doctor/running.ts'
import type { ReachedRecord } from './reached.ts'
import { rehearsalsAt } from './rehearsals.ts'
import { ownWifi } from './own-wifi.ts'

/** The ISO day where this machine stands, so many days from today. */
export function dayHere(offset: number): string {
  const date = new Date()
  date.setDate(date.getDate() + offset)
  const parts = [date.getFullYear(), date.getMonth() + 1, date.getDate()]
  return parts.map((part) => String(part).padStart(2, '0')).join('-')
}

/** Only what went wrong on our side is written: a route's pattern, a status, a code. */
function logTrouble({ method, route, status, error = '' }: LogLine): void {
  if (status >= 500) console.error(`${method} ${route} ${status} ${error}`.trim())
}

function hostOf(database: Database, secret: Uint8Array, { folder, address, reached }: PortOptions): Host {
  const memory = () => process.memoryUsage.rss()
  const { addresses } = reached
  const otherDevice = () => reached.record.otherDevice
  const wifi = ownWifi(process.env)
  const findings = (streams: number) =>
    examineRunning({
      ...{ folder, streams, memory: memory(), now: Date.now(), version: root.version },
      ...{ addresses: addresses(), before: reached.record.addresses, otherDevice: otherDevice() },
      ...{ devices: reached.record.devices(Date.now()), ownTools: database.backup === null },
      hotSpot: wifi?.name ?? null,
    })
  return {
    memory,
    freeSpace: () => {
      const { bavail, bsize } = statfsSync(folder)
      return bavail * bsize
    },
    useReserve: (bytes) => useReserve(folder, bytes),
    ...{ addresses, otherDevice, findings, wifi },
    version: root.version,
    backups: () => {
      if (database.backup === null) return null
      const nights = nightliesIn(folder)
      const broken = otherCopiesIn(folder).broken.length
      return { count: nights.length, last: nights.at(-1)?.day ?? null, broken }
    },
    backUp: () => nightlyBackup({ database, secret, folder, day: dayHere(0) }),
    newestBackup: () => newestBackup(folder),
    rehearse: rehearsalsAt({ data: folder, database: address }),
  }
}

/** The newest backup as a stream; null before there is one. */
function newestBackup(folder: string) {
  const last = lastBackup(folder)
  if (last === null) return null
  const { size } = statSync(last.file)
  const body = Readable.toWeb(createReadStream(last.file)) as ReadableStream<Uint8Array>
  return { name: basename(last.file), size, body }
}

export interface PortOptions {
  readonly folder: string
  /** `postgres://…` where the database is no file in the folder. */
  readonly address?: string | undefined
  readonly publicAddress: string | null
  /** A proxy stands before the server: its own addresses are none for pages. */
  readonly proxied: boolean
  readonly teacherMade: () => void
  readonly steady: () => number
  readonly bus?: Bus
  readonly reached: {
    /** Under which the server is reached now. */
    readonly addresses: () => readonly string[]
    readonly record: ReachedRecord
  }
}

/** Everything real: clock, randomness, a worker that checks projects. */
export function portsOn(database: Database, secret: Uint8Array, options: PortOptions) {
  const checker = checkInWorker()
  const ports: Ports = {
    database,
    now: () => Date.now(),
    steady: options.steady,
    day: dayHere,
    random: (bytes) => new Uint8Array(randomBytes(bytes)),
    secret,
    accounts: accountsOn(database, secret, Date.now),
    checkProject: checker.check,
    save: saveQueueOn(database),
    bury: (tombstone) => Promise.resolve(bury(options.folder, tombstone)),
    log: logTrouble,
    publicOrigin: options.publicAddress,
    announced: ({ reached }) => announcedTo(reached, { ...options, addresses: options.reached.addresses }),
    teacherMade: options.teacherMade,
    limits: new Limits(() => performance.now()),
    live: new Hub(options.bus ?? noBus, { now: () => Date.now(), elapsed: () => performance.now() }),
    cards: cardsInWorker(),
    questionnaires: questionnairesInWorker(),
    host: hostOf(database, secret, options),
  }
  return { ports, close: checker.close }
}
