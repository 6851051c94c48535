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
/** A device that has asked nothing for so long has gone, ms. */
const stays = 300_000
/** More devices than any school has in a room: then those that have gone are forgotten. */
const most = 500

/** Keeps the record of how a server is reached. It holds a time and no address of any device but this one. */
export class ReachedRecord {
  private readonly folder: string
  private reached: Reached
  /** When each other device was last here; it is in no file and in no log. */
  private readonly seen = new Map<string, number>()

  constructor(folder: string) {
    this.folder = folder
    this.reached = readReached(folder)
  }

  /** Where it was reached when it began to listen. */
  get addresses(): readonly string[] {
    return this.reached.addresses
  }

  /** So many other devices were here in the last minutes. @param now ms since 1970 */
  devices(now: number): number {
    for (const [address, at] of this.seen) if (Math.abs(now - at) > stays) this.seen.delete(address)
    return this.seen.size
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
    if (isLocal(address) || this.reached.addresses.some((own) => hostOf(own) === address)) return
    this.seen.set(address, now)
    if (this.seen.size > most) this.devices(now)
    const last = this.reached.otherDevice ?? -Infinity
    if (now - last < anHour && last <= now) return
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
