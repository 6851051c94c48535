import { isKnown, lengthsOf, sourcesAt, sourcesNow, type Lengths } from '../scripts/house.ts'
import { percentile, type Table } from './bench.ts'

/** Before features had doors, content one reader, and edits one way. */
const before = '9f7b64b'
const parts = ['apps/web/src', 'packages']
const goal = { file: 300, component: 110 }

const sum = (numbers: readonly number[]) => numbers.reduce((all, one) => all + one, 0)
const over = (lengths: readonly number[], bound: number) => lengths.filter((length) => length > bound).length
const spread = (lengths: readonly number[]) =>
  lengths.length === 0 ? '–' : [0.5, 0.9, 1].map((share) => percentile(lengths, share)).join(' / ')

const figures: readonly [string, (lengths: Lengths) => number | string][] = [
  ['files', ({ files }) => files.length],
  ['lines', ({ files }) => sum(files)],
  ['files under 25 lines', ({ files }) => files.filter((length) => length < 25).length],
  [`files over ${goal.file} lines`, ({ files }) => over(files, goal.file)],
  ['functions', ({ functions }) => functions.length],
  ['lines of functions: median / p90 / longest', ({ functions }) => spread(functions)],
  ['components', ({ components }) => components.length],
  ['lines of components: median / p90 / longest', ({ components }) => spread(components)],
  [`components over ${goal.component} lines`, ({ components }) => over(components, goal.component)],
]

/** How long files, functions and components are, before and now. */
export default function lengths(): Table {
  const then = isKnown(before) ? parts.map((part) => lengthsOf(sourcesAt(before, part))) : []
  const now = parts.map((part) => lengthsOf(sourcesNow(part)))
  return {
    title: 'Lengths of files, functions and components',
    how: 'What git knows as TypeScript or Svelte, without tests and generated files. A function is what has statements in braces, callbacks among them, from its first word to its last brace; p90: nine of ten are not longer (nearest rank).',
    columns: ['figure', ...parts.flatMap((part) => [`${part}, ${before}`, `${part}, now`])],
    rows: figures.map(([name, figure]) => [
      name,
      ...parts.flatMap((_, part) => [then[part] ? figure(then[part]) : '–', figure(now[part]!)]),
    ]),
    notes: [
      `Goals: functions do not grow (median 5, p90 13 in the web), p90 of components at most ${goal.component}, no file over ${goal.file} lines.`,
    ],
  }
}
