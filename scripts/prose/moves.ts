// Recognises moved files by their prose, so that a move does not count as a new file.

/** A file's prose, one string per line of it. */
export type Lines = readonly string[]

/** A new file is a moved one if at least this share of its lines is in the old one. */
const LEAST_SHARE = 0.5

interface Candidate {
  readonly to: string
  readonly from: string
  readonly share: number
}

/**
 * Pairs new files with deleted ones, the most similar first. Each deleted file is the origin of at most one new file.
 * @returns new path → old path
 */
export function originsOf(
  added: ReadonlyMap<string, Lines>,
  deleted: ReadonlyMap<string, Lines>,
): Map<string, string> {
  const candidates: Candidate[] = []
  for (const [to, lines] of added)
    for (const [from, before] of deleted) candidates.push({ to, from, share: shareOf(lines, before) })
  const origins = new Map<string, string>()
  const used = new Set<string>()
  for (const { to, from, share } of candidates.sort((one, other) => other.share - one.share)) {
    if (share < LEAST_SHARE || origins.has(to) || used.has(from)) continue
    origins.set(to, from)
    used.add(from)
  }
  return origins
}

/** Share of the lines that are among `before`, 0..1. */
function shareOf(lines: Lines, before: Lines): number {
  if (lines.length === 0) return 0
  const known = new Set(before)
  return lines.filter((line) => known.has(line)).length / lines.length
}
