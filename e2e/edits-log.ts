// Results of a long run of random edits in a browser, a line a sequence; edits-row.ts reports them.
import { appendFileSync, existsSync, mkdirSync, readFileSync } from 'node:fs'
import { dirname, join } from 'node:path'

export interface EditSequence {
  readonly sequence: number
  readonly card: string
  /** Edits that happened, those of them that changed the project, and attempts. */
  readonly edits: number
  readonly changes: number
  readonly tried: number
  readonly passed: boolean
}

const file = join(import.meta.dirname, '../node_modules/.cache/edits-in-browser.jsonl')

export function noteSequence(done: EditSequence): void {
  mkdirSync(dirname(file), { recursive: true })
  appendFileSync(file, `${JSON.stringify(done)}\n`)
}

/** The last note of each sequence. */
export function notedSequences(): readonly EditSequence[] {
  if (!existsSync(file)) return []
  const all = readFileSync(file, 'utf8').trim().split('\n')
  const last = new Map(
    all.map((line) => JSON.parse(line) as EditSequence).map((one) => [one.sequence, one] as const),
  )
  return [...last.values()].toSorted((a, b) => a.sequence - b.sequence)
}

export const wasPassed = (sequence: number): boolean =>
  notedSequences().some((one) => one.sequence === sequence && one.passed)
