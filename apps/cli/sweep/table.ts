import type { Shard } from '@botgarten/experiments/sweep'
import { CallError } from '../errors.ts'
import { write } from '../files.ts'
import { message } from '../words.ts'

/** Options of every sweep: how much of it, and where its table goes. */
export const tableOptions = {
  runs: { type: 'string' },
  threads: { type: 'string' },
  shard: { type: 'string' },
  csv: { type: 'string' },
  json: { type: 'boolean' },
} as const

/** `I/N`: the I-th of N parts. */
export function shardIn(text = '1/1'): Shard {
  const [, part, parts] = /^(\d+)\/(\d+)$/.exec(text)?.map(Number) ?? []
  if (part === undefined || parts === undefined || part < 1 || part > parts)
    throw new CallError('call.shard', { text })
  return { part, parts }
}

/** Progress goes beside the result, and only to somebody who looks. */
export function tell(count: number, of: number): void {
  if (process.stderr.isTTY)
    process.stderr.write(`\r${message('learned.progress', { count, all: of })}${count === of ? '\n' : ''}`)
}

/** Where the call names a file the table goes there and a sentence comes back. */
export function handOut(table: string, csv: string | undefined, settings: number): string {
  if (csv === undefined) return table.trimEnd()
  write(csv, table)
  return message('learned.written', { count: settings, path: csv })
}
