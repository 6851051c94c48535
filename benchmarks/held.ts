import { existsSync, mkdirSync, rmdirSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'

const root = '/sys/fs/cgroup'
const period = 100_000

/** Processes that may take a share of one core and no more. */
interface Held {
  /** What starts a program inside, such as Node. */
  readonly prefix: readonly string[]
  /** All of them have ended. */
  readonly close: () => void
}

function groupIn(parent: string, name: string, share: number): string {
  const folder = join(parent, name)
  mkdirSync(folder)
  const quota = share * period
  if (existsSync(join(folder, 'cpu.max'))) writeFileSync(join(folder, 'cpu.max'), `${quota} ${period}`)
  else writeFileSync(join(folder, 'cpu.cfs_quota_us'), String(quota))
  return folder
}

/**
 * A control group of Linux, version 1 or 2.
 * @param share of a core, such as 0.2
 * @returns null where this machine or this user has none to give
 */
export function heldTo(share: number, name: string): Held | null {
  const parent = existsSync(join(root, 'cpu')) ? join(root, 'cpu') : root
  try {
    const folder = groupIn(parent, `botgarten-${process.pid}-${name}`, share)
    const enter = `echo $$ > ${folder}/cgroup.procs && exec "$@"`
    return { prefix: ['sh', '-c', enter, 'sh'], close: () => rmdirSync(folder) }
  } catch {
    return null
  }
}
