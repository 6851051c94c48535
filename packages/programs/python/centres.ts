const most = 9

interface Page {
  readonly source?: unknown
  readonly centres?: unknown
  readonly pages?: unknown
}

const isMiddle = (row: unknown): row is readonly number[] =>
  Array.isArray(row) && row.length === 3 && row.every((part) => Number.isFinite(part))

/** The playground's plane is 10 wide, colours go up to 255. */
const asColour = (part: number) => Math.max(0, Math.min(255, part * 25.5))

/**
 * Middles of groups of colours that the sorting playground of a project has found, red, green and blue 0..255; none where it
 * holds something else.
 */
export function centresIn(sorting: Page | undefined): readonly (readonly number[])[] {
  const pages = [sorting, ...(Array.isArray(sorting?.pages) ? (sorting.pages as readonly Page[]) : [])]
  const centres = pages.find((page) => page?.source === 'readings')?.centres
  if (!Array.isArray(centres) || !centres.every(isMiddle)) return []
  return centres.slice(0, most).map((row) => row.map(asColour))
}
