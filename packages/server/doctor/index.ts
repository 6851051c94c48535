// What can keep a class server from running in a room, found out without changing anything.
import { existsSync } from 'node:fs'
import { networkInterfaces } from 'node:os'
import { join } from 'node:path'
import { nightliesIn, otherCopiesIn } from '@botgarten/classroom'
import { addresses } from '../addresses.ts'
import { readReached } from '../reached.ts'
import { examineBackup } from './backup.ts'
import { examineClock, examineDisk, examineFolder } from './machine.ts'
import { examineAddress, examineFirewall, firewallHere } from './network.ts'
import { oldFiles } from './old-files.ts'
import { examineDoubt, examinePort } from './port.ts'

export interface Examined {
  readonly port: number
  readonly host?: string | undefined
  /** The class server's data folder, which may not be there yet. */
  readonly data: string
}

const dataOf = (data: string) => ({
  exists: existsSync(join(data, 'botgarten.db')),
  nights: nightliesIn(data).map(({ day }) => day),
  others: otherCopiesIn(data),
})

/** Looks at port, address, firewall, clock, disk, data folder and backups, in this order. */
export async function examine({ port, host, data }: Examined) {
  const { addresses: before, otherDevice } = readReached(data)
  return [
    await examinePort(port, host),
    examineAddress(addresses(port, networkInterfaces()), before),
    examineFirewall(firewallHere(port, otherDevice)),
    (await examineDoubt(port, host)) ?? examineClock(Date.now(), oldFiles(data)),
    examineDisk(data),
    examineFolder(data),
    examineBackup(dataOf(data), Date.now()),
  ] as const
}

export type Examination = Awaited<ReturnType<typeof examine>>
