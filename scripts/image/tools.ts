import { existsSync } from 'node:fs'
import { delimiter, join } from 'node:path'

/** A program, and the Debian package that brings it. */
export interface Tool {
  readonly program: string
  readonly from: string
}

export const toBuild: readonly Tool[] = [
  { program: 'mmdebstrap', from: 'mmdebstrap' },
  { program: 'mke2fs', from: 'e2fsprogs' },
  { program: 'mkfs.vfat', from: 'dosfstools' },
  { program: 'mcopy', from: 'mtools' },
  { program: 'zstd', from: 'zstd' },
  { program: 'xz', from: 'xz-utils' },
]
/** Where the machine's own chip is another one. */
export const toEmulate: Tool = { program: 'qemu-aarch64-static', from: 'qemu-user-static' }
export const toTry: readonly Tool[] = [
  { program: 'qemu-system-aarch64', from: 'qemu-system-arm' },
  { program: 'mcopy', from: 'mtools' },
  { program: 'mkfs.vfat', from: 'dosfstools' },
  { program: 'debugfs', from: 'e2fsprogs' },
  { program: 'zstd', from: 'zstd' },
]

const isThere = (program: string) =>
  [...(process.env['PATH'] ?? '').split(delimiter), '/usr/sbin', '/sbin'].some((folder) =>
    existsSync(join(folder, program)),
  )

/** What to install before it works; null: nothing. */
export function missing(tools: readonly Tool[], has: (program: string) => boolean = isThere): string | null {
  const lacking = tools.filter(({ program }) => !has(program))
  if (lacking.length === 0) return null
  const programs = lacking.map(({ program }) => program).join(', ')
  const packages = [...new Set(lacking.map(({ from }) => from))].join(' ')
  return `Missing: ${programs}. On Debian: apt-get install --no-install-recommends ${packages}`
}
