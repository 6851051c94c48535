import { closeSync, openSync, writeSync } from 'node:fs'
import { Zip, ZipDeflate } from 'fflate'

/** A file in a zip. */
export interface Entry {
  /** With `/` between folders. */
  readonly path: string
  readonly read: () => Uint8Array
  /** May it be started? */
  readonly program: boolean
}

const unix = 3
const modeOf = ({ program }: Entry) => (program ? 0o100755 : 0o100644)

/**
 * Writes a zip in which programs are marked as such: what unpacks it on macOS and Linux sets their mode.
 * @param date of all files, so that the same files give the same bytes
 */
export function writeZip(file: string, entries: readonly Entry[], date: Date): void {
  const target = openSync(file, 'w')
  try {
    const zip = new Zip((error, part) => {
      if (error) throw error
      writeSync(target, part)
    })
    for (const entry of entries) {
      const one = new ZipDeflate(entry.path, { level: 6 })
      // The upper half of the attributes is the mode where the system is Unix (APPNOTE 4.4.15).
      Object.assign(one, { mtime: date, os: unix, attrs: modeOf(entry) * 0x10000 })
      zip.add(one)
      one.push(entry.read(), true)
    }
    zip.end()
  } finally {
    closeSync(target)
  }
}
