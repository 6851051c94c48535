// What can keep a class server from running in a room, found out without changing anything.
import { existsSync, readFileSync, statSync } from 'node:fs'
import { networkInterfaces } from 'node:os'
import { join } from 'node:path'
import { lastBackup } from '@botgarten/classroom'
import { addresses } from '../addresses.ts'
import { readReached } from '../reached.ts'
import { inRepository } from '../repository.ts'
import { examineClock, examineDisk, examineFolder } from './machine.ts'
import { examineAddress, examineFirewall } from './network.ts'
import { examinePort } from './port.ts'

export interface Examined {
  readonly port: number
  readonly host?: string | undefined
  /** The class server's data folder, which may not be there yet. */
  readonly data: string
}

const writtenAt = (file: string | null) => (file !== null && existsSync(file) ? [statSync(file).mtimeMs] : [])

/** Files that were certainly written before now: the product, and what a server of it has saved. */
const oldFiles = (data: string) =>
  [inRepository('package.json'), join(data, 'botgarten.db'), lastBackup(data)].flatMap(writtenAt)

const ufwFile = '/etc/ufw/ufw.conf'

/** Looks at port, address, firewall, clock, disk and data folder, in this order. */
export async function examine({ port, host, data }: Examined) {
  const { addresses: before, otherDevice } = readReached(data)
  const ufw = existsSync(ufwFile) ? readFileSync(ufwFile, 'utf8') : null
  return [
    await examinePort(port, host),
    examineAddress(addresses(port, networkInterfaces()), before),
    examineFirewall({ platform: process.platform, port, ufw, reachedAt: otherDevice }),
    examineClock(Date.now(), oldFiles(data)),
    examineDisk(data),
    examineFolder(data),
  ] as const
}

export type Examination = Awaited<ReturnType<typeof examine>>
