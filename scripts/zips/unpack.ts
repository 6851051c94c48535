import { chmodSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { dirname, join } from 'node:path'
import { unzipSync } from 'fflate'

/** Modes of the files of a zip, as its central directory has them (APPNOTE 4.3.12). */
export function modesIn(zip: Buffer): Map<string, number> {
  const modes = new Map<string, number>()
  let at = zip.readUInt32LE(zip.lastIndexOf(Buffer.from([0x50, 0x4b, 5, 6])) + 16)
  while (zip.readUInt32LE(at) === 0x02014b50) {
    const [name, extra, comment] = [28, 30, 32].map((offset) => zip.readUInt16LE(at + offset))
    modes.set(zip.toString('utf8', at + 46, at + 46 + name!), zip.readUInt32LE(at + 38) >>> 16)
    at += 46 + name! + extra! + comment!
  }
  return modes
}

/** Unpacks a zip as the tools of Linux and macOS do: with the modes of its files. */
export function unpack(file: string, folder: string): void {
  const zip = readFileSync(file)
  const modes = modesIn(zip)
  for (const [path, bytes] of Object.entries(unzipSync(zip))) {
    const target = join(folder, path)
    mkdirSync(dirname(target), { recursive: true })
    writeFileSync(target, bytes)
    chmodSync(target, modes.get(path)! & 0o777)
  }
}
