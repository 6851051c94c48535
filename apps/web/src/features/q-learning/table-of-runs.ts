import type { LearnedRun } from '@botgarten/programs'

const columns = [
  ...[
    'map',
    'start',
    'goal',
    'closed',
    'rules',
    'alpha',
    'gamma',
    'nu',
    'rho',
    'limitEpisodes',
    'limitMoves',
  ],
  ...['seed', 'episodes', 'moves', 'way', 'shortest', 'found', 'guess', 'pay'],
] as const satisfies readonly (keyof LearnedRun)[]

/** All runs as CSV (RFC 4180): a head, then a row a run, numbers with a decimal point. */
export function csvOf(runs: readonly LearnedRun[]): string {
  const rows = runs.map((run) => columns.map((column) => cell(run[column] ?? '')))
  return [columns, ...rows].map((row) => row.join(',')).join('\r\n') + '\r\n'
}

/** A spreadsheet takes what begins so for a formula; whoever opens the table did not write it. */
const formula = /^[=+@\t]/

function cell(value: string | number): string {
  const text = typeof value === 'string' && formula.test(value) ? `'${value}` : String(value)
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text
}
