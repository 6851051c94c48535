// `npm run edits:browser`: appends the results of the random edits in a browser to benchmarks/results/edits.md.
// tests/random-edits.spec.ts notes each sequence.
import { execFileSync } from 'node:child_process'
import { readFileSync, writeFileSync } from 'node:fs'
import { notedSequences } from './edits-log.ts'

const file = new URL('../benchmarks/results/edits.md', import.meta.url)
const heading = '## In a browser'
const about = `${heading}

Sequences of at least 8 edits in Chromium while a card runs, each on the next card; an edit counts if it happened. What the page shows and the device has saved is the same after two reloads. Made by \`npm run edits:browser\`, which goes on where it was ended.

| date | commit | sequences | cards | edits | that changed the project | attempts | failed |
| --- | --- | --: | --: | --: | --: | --: | --- |
`

const all = notedSequences()
const sum = (of: (one: (typeof all)[number]) => number) => all.reduce((total, one) => total + of(one), 0)
const failed = all.filter(({ passed }) => !passed).map(({ sequence, card }) => `${sequence} (${card})`)
const commit = execFileSync('git', ['rev-parse', '--short=8', 'HEAD'], { encoding: 'utf8' }).trim()
const cells = [
  ...[new Date().toISOString().slice(0, 10), commit, all.length, new Set(all.map(({ card }) => card)).size],
  ...[
    sum(({ edits }) => edits),
    sum(({ changes }) => changes),
    sum(({ tried }) => tried),
    failed.join(', ') || 'none',
  ],
]
const row = `| ${cells.join(' | ')} |`
const text = readFileSync(file, 'utf8')
writeFileSync(file, `${text.includes(heading) ? text : `${text.trimEnd()}\n\n${about}`}${row}\n`)
console.log(row)
