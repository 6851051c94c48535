// Disks that are small, full or read-only: only root may mount them.
import { execFileSync } from 'node:child_process'
import { mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { test } from 'vitest'

export const mount = (...args: readonly string[]) => execFileSync('mount', args, { stdio: 'ignore' })
const unmount = (at: string) => execFileSync('umount', ['--lazy', at])
const newFolder = () => mkdtempSync(join(tmpdir(), 'botgarten-disk-'))

function reasonAgainst(): string | null {
  if (process.platform !== 'linux' || process.getuid?.() !== 0) return 'only root may mount a small disk'
  const at = newFolder()
  try {
    mount('-t', 'tmpfs', '-o', 'size=1m', 'tmpfs', at)
    unmount(at)
    return null
  } catch {
    return 'this machine does not let us mount a small disk'
  } finally {
    rmSync(at, { recursive: true, force: true })
  }
}

const reason = reasonAgainst()

/** A test on a disk of its own; skipped on machines that cannot mount it. @param megabytes size of the disk */
export const testOnDisk = (
  name: string,
  megabytes: number,
  work: (disk: string) => void | Promise<void>,
): void =>
  test.skipIf(reason !== null)(`${name}${reason ? ` (skipped: ${reason})` : ''}`, async () => {
    const disk = newFolder()
    mount('-t', 'tmpfs', '-o', `size=${megabytes}m`, 'tmpfs', disk)
    try {
      await work(disk)
    } finally {
      unmount(disk)
      rmSync(disk, { recursive: true, force: true })
    }
  })
