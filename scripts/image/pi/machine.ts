// What the programs of this folder do with the Pi itself: its boot partition, its screen.
import { execFileSync } from 'node:child_process'
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { readSettings, type Settings } from './settings.ts'
import { startedFrom } from './slots.ts'

export const data = '/var/lib/botgarten'
export const lab = `${data}/lab`
/** User and group of the lab (usr/lib/sysusers.d). */
export const labUser = 900

export const here = startedFrom(readFileSync('/proc/cmdline', 'utf8')) ?? { disk: '00000000', slot: 'a' }

export const textIn = (file: string): string | null => (existsSync(file) ? readFileSync(file, 'utf8') : null)

export function run(program: string, ...args: string[]): void {
  execFileSync(program, args, { stdio: ['ignore', 'ignore', 'inherit'] })
}

/** Mounts a partition for the time of `work`. */
function mounted<T>(device: string, mode: 'ro' | 'rw', work: (folder: string) => T): T {
  const folder = '/run/botgarten/mounted'
  mkdirSync(folder, { recursive: true })
  const options = mode === 'ro' ? 'ro' : 'rw,flush'
  run('mount', '-o', `${options},nodev,nosuid,noexec,umask=077`, device, folder)
  try {
    return work(folder)
  } finally {
    run('umount', folder)
  }
}

const bootPartition = `/dev/disk/by-partuuid/${here.disk}-01`
export const readBoot = <T>(work: (folder: string) => T): T => mounted(bootPartition, 'ro', work)
export const writeBoot = <T>(work: (folder: string) => T): T => mounted(bootPartition, 'rw', work)

/** In its place: a file of the same length changes one sector. */
export const overwrite = (folder: string, name: string, text: string): void =>
  writeFileSync(join(folder, name), text, { flag: existsSync(join(folder, name)) ? 'r+' : 'w', flush: true })

const kept = '/run/botgarten/settings.json'
export const settings = (): Settings =>
  JSON.parse(textIn(kept) ?? JSON.stringify(readSettings(''))) as Settings
export const keepSettings = (found: Settings): void => writeFileSync(kept, JSON.stringify(found))

/** Replaces what stands on the screen, where there is one. */
export function show(text: string): void {
  if (existsSync('/dev/tty1'))
    writeFileSync(
      '/dev/tty1',
      `\u001b%G\u001b[2J\u001b[H${text.replaceAll('…', '...').replaceAll('\n', '\r\n')}`,
    )
}
