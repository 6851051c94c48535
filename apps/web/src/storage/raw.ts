/** Deeper than any project, and not so deep that writing it runs out of stack. */
const deepest = 500

/** Whatever lies in a record, as text for a file. What text cannot hold is named. */
export function rawText(value: unknown): string {
  try {
    const text = JSON.stringify(value) as string | undefined
    if (text !== undefined) return text
  } catch {
    // A circle, a number without end, or deeper than JSON can write.
  }
  return JSON.stringify(plain(value, 0, new Set())) ?? 'null'
}

function plain(value: unknown, depth: number, above: ReadonlySet<unknown>): unknown {
  if (typeof value === 'bigint' || typeof value === 'symbol') return String(value)
  if (typeof value !== 'object' || value === null) return value
  if (depth > deepest || above.has(value)) return '…'
  const inside = new Set(above).add(value)
  if (Array.isArray(value)) return value.map((one) => plain(one, depth + 1, inside))
  return Object.fromEntries(Object.entries(value).map(([key, one]) => [key, plain(one, depth + 1, inside)]))
}
