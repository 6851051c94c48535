import { existsSync, readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import * as v from 'valibot'

const shape = v.object({
  /** Where the server was reached at its last start. */
  addresses: v.array(v.pipe(v.string(), v.url())),
  /** When another device last reached it, ms since 1970; null: none has. */
  otherDevice: v.nullable(v.number()),
})
type Reached = v.InferOutput<typeof shape>

const nobody: Reached = { addresses: [], otherDevice: null }
const fileIn = (folder: string) => join(folder, 'reached.json')

/** How a data folder's server was reached; of nobody where there is no record of it. */
export function readReached(folder: string): Reached {
  if (!existsSync(fileIn(folder))) return nobody
  try {
    return v.parse(shape, JSON.parse(readFileSync(fileIn(folder), 'utf8')))
  } catch {
    return nobody
  }
}

const isLocal = (address: string) => address === '::1' || address.startsWith('127.')
const hostOf = (address: string) => new URL(address).hostname.replace(/^\[|\]$/g, '')
const anHour = 3_600_000

/** Keeps the record of how a server is reached. It holds a time and no address of any device but this one. */
export class ReachedRecord {
  private readonly folder: string
  private reached: Reached

  constructor(folder: string) {
    this.folder = folder
    this.reached = readReached(folder)
  }

  get otherDevice(): number | null {
    return this.reached.otherDevice
  }

  /** The server has begun to listen. */
  startAt(addresses: readonly string[]): void {
    this.save({ ...this.reached, addresses: [...addresses] })
  }

  /** Somebody asked. @param now ms since 1970 */
  note(address: string, now: number): void {
    const last = this.reached.otherDevice ?? -Infinity
    if (now - last < anHour && last <= now) return
    if (isLocal(address) || this.reached.addresses.some((own) => hostOf(own) === address)) return
    this.save({ ...this.reached, otherDevice: now })
  }

  /** A full disk may not keep the server from answering: then there is no record. */
  private save(reached: Reached) {
    this.reached = reached
    try {
      writeFileSync(fileIn(this.folder), JSON.stringify(reached))
    } catch {
      // What is in memory is enough for this run.
    }
  }
}
