// What a running server finds out about itself and its machine, for its teachers: as the doctor does, without the port.
import { nightliesIn, otherCopiesIn, type Finding } from '@botgarten/classroom'
import { examineBackup } from './backup.ts'
import { fine, wrong } from './finding.ts'
import { examineClock, examineDisk, examineFolder } from './machine.ts'
import { examineAddress, examineFirewall, firewallHere } from './network.ts'
import { oldFiles } from './old-files.ts'

export interface Running {
  readonly folder: string
  /** Where it is reached now, and where it was when it began to listen. */
  readonly addresses: readonly string[]
  readonly before: readonly string[]
  /** When another device last reached it, ms since 1970; null: none has. */
  readonly otherDevice: number | null
  /** Other devices that were here in the last minutes. */
  readonly devices: number
  /** Open ones of pages. */
  readonly streams: number
  /** Of the process, bytes. */
  readonly memory: number
  /** The database is no file of ours. */
  readonly ownTools: boolean
  readonly version: string
  readonly now: number
  /** Name of the Wi-Fi that this machine makes itself; null: it makes none. */
  readonly hotSpot: string | null
}

const megabyte = 1_000_000
/** A class of 35 takes 160 MB. */
const mostMemory = 192

export function examineMemory(bytes: number) {
  const facts = { used: Math.round(bytes / megabyte), most: mostMemory }
  return facts.used > mostMemory ? wrong('memory.high', facts) : fine('memory.fine', facts)
}

/** The Wi-Fi of a Raspberry Pi carries 7 to 10 devices. */
const mostInHotSpot = 8

export function examineHotSpot(name: string, devices: number) {
  const facts = { name, devices }
  return devices > mostInHotSpot ? wrong('hotspot.crowded', facts) : fine('hotspot.fine', facts)
}

/** Of http where none is named. */
const portOf = (addresses: readonly string[]) =>
  Number(new URL(addresses[0] ?? 'http://localhost').port || 80)
const isSecure = (address: string) => address.startsWith('https:')

export function examineRunning(running: Running): readonly Finding[] {
  const { folder, addresses, devices, streams, hotSpot, now } = running
  const plain = (list: readonly string[]) => list.filter((address) => !isSecure(address))
  const nights = nightliesIn(folder).map(({ day }) => day)
  const saved = { exists: true, nights, others: otherCopiesIn(folder) }
  return [
    examineAddress(plain(addresses), plain(running.before)),
    examineFirewall(firewallHere(portOf(plain(addresses)), running.otherDevice)),
    fine('clients.now', { devices, streams }),
    ...(hotSpot === null ? [] : [examineHotSpot(hotSpot, devices)]),
    addresses.some(isSecure) ? fine('https.on') : wrong('https.off'),
    examineMemory(running.memory),
    examineDisk(folder),
    examineClock(now, oldFiles(folder)),
    running.ownTools ? fine('backup.ownTools') : examineBackup(saved, now),
    examineFolder(folder),
    fine('version.is', { version: running.version }),
  ]
}
