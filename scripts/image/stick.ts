import { execFileSync } from 'node:child_process'
import { createHash } from 'node:crypto'
import { createReadStream, statSync, writeFileSync } from 'node:fs'
import { basename } from 'node:path'
import { setTimeout as after } from 'node:timers/promises'
import type { Guest } from './guest.ts'

async function sumOf(file: string): Promise<string> {
  const hash = createHash('sha256')
  for await (const part of createReadStream(file)) hash.update(part as Buffer)
  return hash.digest('hex')
}

/** A USB stick with an update on it. @param consent the checksum that a teacher put beside it */
export async function stickWith(
  stick: string,
  update: string,
  consent: 'none' | 'wrong' | 'right',
): Promise<string> {
  const mb = Math.ceil(statSync(update).size / 1e6) + 64
  execFileSync('truncate', ['-s', '0', stick])
  execFileSync('truncate', ['-s', `${mb}M`, stick])
  execFileSync('mkfs.vfat', ['-F', '32', '-n', 'STICK', stick], { stdio: 'ignore' })
  execFileSync('mcopy', ['-i', stick, update, '::'])
  if (consent === 'none') return stick
  const sum = consent === 'right' ? await sumOf(update) : '0'.repeat(64)
  writeFileSync(`${stick}.txt`, `${sum}  ${basename(update)}\r\n`)
  execFileSync('mcopy', ['-i', stick, `${stick}.txt`, '::/install.txt'])
  return stick
}

/** A stick with an empty file on it, which is to be filled. */
export function stickThatAsks(stick: string, name: string): string {
  execFileSync('truncate', ['-s', '0', stick])
  execFileSync('truncate', ['-s', '64M', stick])
  execFileSync('mkfs.vfat', ['-F', '32', '-n', 'STICK', stick], { stdio: 'ignore' })
  writeFileSync(`${stick}.txt`, '')
  execFileSync('mcopy', ['-i', stick, `${stick}.txt`, `::/${name}`])
  return stick
}

export const onStick = (stick: string, name: string): string =>
  execFileSync('mtype', ['-i', stick, `::/${name}`], { encoding: 'utf8' })

let sticks = 0

export async function plugIn(guest: Guest, stick: string): Promise<void> {
  sticks++
  await guest.monitor(`drive_add 0 if=none,id=drive${sticks},file=${stick},format=raw`)
  await guest.monitor(`device_add usb-storage,drive=drive${sticks},id=stick${sticks},removable=on`)
}

export async function pullOut(guest: Guest): Promise<void> {
  await guest.monitor(`device_del stick${sticks}`)
  await after(3000)
}
