import type { Block } from '../types.ts'

const names: string[] = []

/** `ADD0`, `ADD1`, …: made once, since a net asks for them in every run. */
export function rowName(k: number): string {
  while (names.length <= k) names.push(`ADD${names.length}`)
  return names[k] ?? ''
}

/** No list is longer, whatever a file says. */
const mostRows = 10_000

/** How many rows a growing list has: what its mutation says, else one more than its last filled row. */
export function rowCount(block: Block): number {
  const said = Number(block.mutation?.attrs.items)
  if (said >= 0) return Math.min(Math.floor(said), mostRows)
  let count = 0
  for (const name of Object.keys(block.values ?? {})) {
    if (/^ADD\d+$/.test(name)) count = Math.max(count, Number(name.slice(3)) + 1)
  }
  return Math.min(count, mostRows)
}

/** What is plugged into an input and not switched off. */
export function plugged(block: Block, input: string): Block | undefined {
  const child = block.values?.[input]
  return child?.disabled === true ? undefined : child
}

/** The filled rows of a list, top to bottom. */
export function filledRows(list: Block): readonly Block[] {
  const rows = Array.from({ length: rowCount(list) }, (_, k) => plugged(list, rowName(k)))
  return rows.filter((row) => row !== undefined)
}
