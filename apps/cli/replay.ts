import { csv } from '@botgarten/answers'
import { content } from '@botgarten/content/files'
import {
  isSame,
  readLog,
  replay as playAgain,
  rowsOfTable,
  tableOf,
  type Fault,
  type Numbered,
  type Replay,
} from '@botgarten/experiments/study'
import { version } from '@botgarten/programs'
import type { Command } from './commands.ts'
import { CallError, FileError } from './errors.ts'
import { readText } from './files.ts'
import { floorOf } from './floor.ts'
import { note } from './notes.ts'
import { options } from './options.ts'
import { message } from './words.ts'

const known = { csv: { type: 'boolean' }, json: { type: 'boolean' } } as const

/** In megabytes: a lesson of a class has about thirty. */
const tooLarge = 400
/** So many refused lines are named one by one. */
const named = 20

/** `botgarten replay FILE.jsonl [--csv] [--json]`: a log of a study to the same hashes, and a table of its children. */
export const replay: Command = { options: known, execute: replayOnce }

function replayOnce(args: string[]): string {
  const { values, positionals } = options(args, known)
  const [path, ...more] = positionals
  if (!path || more.length > 0) throw new CallError('call.replayWhat')
  if (values.csv && values.json) throw new CallError('call.csvOrJson')
  const { lines, faults } = readLog(readText(path, tooLarge))
  refuse(path, faults)
  if (lines.length === 0) throw new FileError('file.emptyLog', { path })
  const played = playAgain(lines, {
    floorOf,
    checksOf: (place) => content.card(place)?.card.checks ?? [],
  })
  refuse(path, played.faults)
  compare(path, played)
  if (values.csv) return csv(rowsOfTable(tableOf(lines))).trimEnd()
  return values.json ? JSON.stringify(reportOf(lines, played)) : sentencesOf(lines, played)
}

function refuse(path: string, faults: readonly Fault[]): void {
  if (faults.length === 0) return
  for (const { line, reason, facts } of faults.slice(0, named))
    note(message('file.logLine', { path, line, why: message(`log.${reason}`, facts) }))
  throw new FileError('file.logFaults', { path, count: faults.length })
}

/** Another version may drive otherwise: that is said. The same one drives the same, or the file was changed. */
function compare(path: string, { runs, versions }: Replay): void {
  const others = versions.filter((one) => one !== version)
  if (others.length > 0) note(message('replayed.otherVersion', { versions: others.join(', '), version }))
  const unequal = runs.find((run) => !isSame(run))
  if (!unequal) return
  const { line, pseudonym, hash, again } = unequal
  const facts = { path, line, pseudonym, hash, again }
  if (others.length === 0) throw new FileError('file.otherHash', facts)
  note(message('replayed.firstUnequal', facts))
}

const reportOf = (lines: readonly Numbered[], { runs, versions }: Replay) => ({
  version,
  versions,
  lines: lines.length,
  runs: runs.map((run) => ({ ...run, same: isSame(run) })),
  pupils: tableOf(lines),
})

function sentencesOf(lines: readonly Numbered[], { runs }: Replay): string {
  const [names, ...rows] = rowsOfTable(tableOf(lines))
  const table = [names!.map((name) => message(`replayed.column.${name as 'tries'}`)), ...rows]
  const photos = runs.filter(({ photo }) => photo).length
  return [
    message('replayed.runs', { runs: runs.length, same: runs.filter(isSame).length - photos }),
    ...(photos > 0 ? [message('replayed.photos', { photos })] : []),
    '',
    ...aligned(table.map((row) => row.map(String))),
  ].join('\n')
}

function aligned(rows: readonly (readonly string[])[]): readonly string[] {
  const widths = rows[0]!.map((_, at) => Math.max(...rows.map((row) => row[at]!.length)))
  return rows.map((row) => row.map((cell, at) => cell.padStart(widths[at]!)).join('  '))
}
