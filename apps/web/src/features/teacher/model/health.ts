import { writeNumber } from '@botgarten/messages'
import { addressFor, isOwnMachine, type Place } from '#parts/page/address.ts'
import { m } from '#words/message.ts'
import type { Health } from './answers.ts'
import { dayLabel } from './ends.ts'

/** One line of the server's health. */
export interface Fact {
  readonly id: string
  readonly fine: boolean
  readonly title: string
  readonly text: string
  readonly value: string
}

const limits = { memory: 192_000_000, freeSpace: 500_000_000, clock: 120_000 }

const megabytes = (bytes: number) => Math.round(bytes / 1_000_000)
const gigabytes = (bytes: number, locale: string) => writeNumber(bytes / 1_000_000_000, locale, { most: 1 })

function addressFact(at: Place, announced: string | null, wifi: string | null): Fact {
  const address = new URL(addressFor(at, announced))
  const fine = !isOwnMachine(address.hostname)
  const reached = wifi === null ? m['teacher.addressText']() : m['teacher.wifiFact']({ name: wifi })
  const text = fine ? reached : m['teacher.addressOwn']()
  return { id: 'address', fine, title: m['teacher.address'](), text, value: address.host }
}

const offlineFact = (secure: boolean): Fact => ({
  ...{ id: 'offline', fine: secure, title: m['teacher.offline']() },
  text: secure ? m['teacher.offlineText']() : m['teacher.offlineHttps'](),
  value: secure ? m['teacher.yes']() : m['teacher.notYet'](),
})

const memoryFact = ({ memory }: Health): Fact => ({
  ...{ id: 'memory', fine: memory <= limits.memory, title: m['teacher.memory']() },
  text: m['teacher.memoryText']({ most: megabytes(limits.memory) }),
  value: m['teacher.megabytes']({ count: megabytes(memory) }),
})

const spaceFact = ({ freeSpace }: Health, locale: string): Fact => ({
  ...{ id: 'space', fine: freeSpace >= limits.freeSpace, title: m['teacher.freeSpace']() },
  text: m['teacher.freeSpaceText']({ least: gigabytes(limits.freeSpace, locale) }),
  value: m['teacher.gigabytes']({ count: gigabytes(freeSpace, locale) }),
})

function clockFact({ now }: Health, here: number, locale: string): Fact {
  const fine = Math.abs(now - here) < limits.clock
  return {
    ...{ id: 'clock', fine, title: m['teacher.clock']() },
    text: fine ? m['teacher.clockText']() : m['teacher.clockWrong'](),
    value: new Date(now).toLocaleTimeString(locale, { hour: 'numeric', minute: '2-digit' }),
  }
}

function backupFact({ backups }: Health, locale: string): Fact {
  const title = m['teacher.backup']()
  if (!backups)
    return {
      id: 'backup',
      fine: true,
      title,
      text: m['teacher.backupDump'](),
      value: m['teacher.byOwnTools'](),
    }
  const fine = backups.last !== null
  return {
    ...{ id: 'backup', fine, title, text: fine ? m['teacher.backupText']() : m['teacher.backupFirst']() },
    value: backups.last === null ? m['teacher.noneYet']() : dayLabel(backups.last, locale),
  }
}

const clientsFact = ({ otherDevice, streams }: Health): Fact => ({
  ...{ id: 'clients', fine: otherDevice !== null, title: m['teacher.clients']() },
  text: otherDevice === null ? m['teacher.clientsNone']() : m['teacher.clientsText'](),
  value: String(streams),
})

const versionFact = ({ version }: Health): Fact => ({
  ...{ id: 'version', fine: true, title: m['teacher.version']() },
  ...{ text: m['teacher.versionText'](), value: version },
})

interface Known {
  readonly secure: boolean
  /** The address that the server announces; null: not known. */
  readonly announced: string | null
  /** What the server reports to a teacher; null: nothing yet. */
  readonly health: Health | null
  /** The time by this device's clock when it was reported. */
  readonly here: number
  /** Name of the Wi-Fi of the room, where it was named. */
  readonly wifi: string | null
}

/** How the server is, a line a fact. */
export function healthOf(
  at: Place,
  { secure, announced, health, here, wifi }: Known,
  locale: string,
): readonly Fact[] {
  const known = health
    ? [
        clientsFact(health),
        memoryFact(health),
        spaceFact(health, locale),
        clockFact(health, here, locale),
        backupFact(health, locale),
      ]
    : []
  const last = health ? [versionFact(health)] : []
  return [addressFact(at, announced, wifi), ...known, offlineFact(secure), ...last]
}
