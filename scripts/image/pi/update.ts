/** What lies on a USB stick, and what is known of the systems on the card. */
export interface Stick {
  /** Names of its files. */
  readonly files: readonly string[]
  /** What a teacher wrote or copied into `install.txt`; null: there is none. */
  readonly consent: string | null
  /** Checksums of the updates that the two systems were made from. */
  readonly known: readonly string[]
}

export type Decision =
  | { readonly do: 'nothing' }
  /** Says on the screen what a teacher does to have it. */
  | { readonly do: 'ask' | 'several' | 'noChecksum' }
  /** Installs it if the file has this checksum. */
  | { readonly do: 'install'; readonly file: string; readonly sha256: string }

const isUpdate = (name: string) => /^botgarten-pi-[\w.-]+\.update$/i.test(name)

/** The file by which a teacher says yes: it holds the checksum, such as the line of SHA256SUMS. */
export const consentFile = 'install.txt'

/**
 * An update is installed when one file of it lies on the stick and a teacher has put its checksum beside it. One that was
 * installed or tried already is not tried again while the stick stays in.
 */
export function decide({ files, consent, known }: Stick): Decision {
  const updates = files.filter(isUpdate)
  if (updates.length === 0) return { do: 'nothing' }
  if (updates.length > 1) return { do: 'several' }
  if (consent === null) return { do: 'ask' }
  const lines = consent.split(/\r?\n/).filter((line) => /\b[0-9a-f]{64}\b/i.test(line))
  const line = lines.length === 1 ? lines[0]! : lines.find((one) => one.includes(updates[0]!))
  if (line === undefined) return { do: 'noChecksum' }
  const sha256 = /\b[0-9a-f]{64}\b/i.exec(line)![0].toLowerCase()
  return known.includes(sha256) ? { do: 'nothing' } : { do: 'install', file: updates[0]!, sha256 }
}
