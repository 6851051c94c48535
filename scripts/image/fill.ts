import { execFileSync } from 'node:child_process'
import {
  chownSync,
  closeSync,
  copyFileSync,
  ftruncateSync,
  globSync,
  mkdirSync,
  openSync,
  readFileSync,
  rmSync,
  writeFileSync,
  writeSync,
} from 'node:fs'
import { basename, join } from 'node:path'
import { bootRecord, diskId, mib, partitions, place, sector, sizeOf, type Partition } from './partitions.ts'
import { fill, type Slot } from './pi/slots.ts'

const here = import.meta.dirname
const quiet = (program: string, ...args: string[]) =>
  execFileSync(program, args, { stdio: ['ignore', 'ignore', 'inherit'] })

function empty(folder: string): string {
  rmSync(folder, { recursive: true, force: true })
  mkdirSync(folder, { recursive: true })
  return folder
}

function emptyFile(file: string, bytes: number) {
  const opened = openSync(file, 'w')
  ftruncateSync(opened, bytes)
  closeSync(opened)
}

const sizeFor = (name: Partition['name']) => partitions.find((one) => one.name === name)!.mib * mib

/** What the firmware loads of a Pi 3 and a Pi 4; those that are cut down or for cameras are left out. */
const firmware = ['bootcode.bin', 'start.elf', 'fixup.dat', 'start4.elf', 'fixup4.dat']
/** A Pi 5 (bcm2712) is left out: this kernel does not drive its ports. */
const deviceTrees = 'usr/lib/linux-image-*/broadcom/bcm{2837,2711}-rpi-*.dtb'

/** Kernel, first root and device trees of a system. */
export function systemFiles(tree: string, folder: string): void {
  empty(folder)
  const one = (pattern: string) => globSync(join(tree, pattern))[0]!
  copyFileSync(one('boot/vmlinuz-*'), join(folder, 'vmlinuz'))
  copyFileSync(one('boot/initrd.img-*'), join(folder, 'initrd.img'))
  for (const file of globSync(join(tree, deviceTrees))) copyFileSync(file, join(folder, basename(file)))
  copyFileSync(join(here, 'boot/cmdline.txt'), join(folder, 'cmdline.txt'))
}

const fillCommandLine = (folder: string, slot: Slot) => {
  const file = join(folder, 'cmdline.txt')
  writeFileSync(file, fill(readFileSync(file, 'utf8'), diskId, slot))
}

/** The boot partition, filled without being mounted. @param system folder of `systemFiles` */
export function bootImage(tree: string, system: string, work: string): string {
  const [folder, file] = [empty(join(work, 'boot')), join(work, 'boot.img')]
  for (const name of firmware) copyFileSync(join(tree, 'usr/lib/raspi-firmware', name), join(folder, name))
  for (const name of ['config.txt', 'slot.txt', 'botgarten.txt'])
    copyFileSync(join(here, 'boot', name), join(folder, name))
  mkdirSync(join(folder, 'a'))
  for (const from of globSync(join(system, '*'))) copyFileSync(from, join(folder, 'a', basename(from)))
  fillCommandLine(join(folder, 'a'), 'a')
  emptyFile(file, sizeFor('boot'))
  quiet('mkfs.vfat', '-F', '32', '-n', 'BOTGARTEN', '-i', diskId, file)
  quiet('mcopy', '-s', '-i', file, ...globSync(join(folder, '*')), '::')
  return file
}

/** The root of a system: it is never written, so it needs no journal. */
export function rootImage(tree: string, work: string): string {
  const file = join(work, 'root.img')
  emptyFile(file, sizeFor('a'))
  const options = ['-q', '-F', '-t', 'ext4', '-b', '4096', '-m', '0', '-O', '^has_journal', '-L', 'botgarten']
  quiet('mke2fs', ...options, '-d', tree, file)
  return file
}

/** Number of a user in the tree. */
function idOf(user: string, tree: string): number {
  const line = readFileSync(join(tree, 'etc/passwd'), 'utf8')
    .split('\n')
    .find((one) => one.startsWith(`${user}:`))
  return Number(line!.split(':')[2])
}

/** The data's partition: empty but for who may write where. Its journal and blocks are those of a large one. */
export function dataImage(tree: string, work: string): string {
  const [folder, file] = [empty(join(work, 'data')), join(work, 'data.img')]
  for (const [name, user] of [
    ['lab', 'botgarten'],
    ['clock', 'systemd-timesync'],
  ] as const) {
    mkdirSync(join(folder, name), { mode: name === 'lab' ? 0o700 : 0o755 })
    chownSync(join(folder, name), idOf(user, tree), idOf(user, tree))
  }
  emptyFile(file, sizeFor('data'))
  const options = ['-q', '-F', '-t', 'ext4', '-b', '4096', '-i', '16384', '-J', 'size=32', '-m', '1']
  quiet('mke2fs', ...options, '-L', 'botgarten-data', '-d', folder, file)
  return file
}

/** Puts all partitions into one file, with holes where there is nothing. */
export function cardImage(file: string, images: { readonly [name in Partition['name']]?: string }): void {
  const placed = place(partitions)
  emptyFile(file, sizeOf(placed))
  const opened = openSync(file, 'r+')
  writeSync(opened, bootRecord(placed, diskId), 0, sector, 0)
  closeSync(opened)
  for (const { name, start } of placed) {
    const image = images[name]
    if (image === undefined) continue
    const at = `seek=${(start * sector) / mib}`
    quiet('dd', `if=${image}`, `of=${file}`, 'bs=1M', at, 'conv=notrunc,sparse', 'status=none')
  }
}

/** What a stick brings: the root, packed, and what the boot partition holds of a system. */
export function updateFile(file: string, root: string, system: string, work: string): void {
  const packed = join(work, 'root.img.zst')
  quiet('zstd', '-q', '-f', '-T0', '-3', root, '-o', packed)
  const names = globSync(join(system, '*')).map((path) => basename(path))
  quiet('tar', '-cf', file, '-C', system, ...names, '-C', work, 'root.img.zst')
}
