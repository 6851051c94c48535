import { spawnSync } from 'node:child_process'
import { join } from 'node:path'
import type { Table } from './bench.ts'

interface Row {
  readonly map: string
  readonly alpha: number
  readonly gamma: number
  readonly nu: number
  readonly rho: number
  readonly runs: number
  readonly foundShortest: number
  readonly medianFirst: number | null
}

const program = join(import.meta.dirname, '../apps/cli/botgarten.ts')
const shown = 5

/** Most runs that found a shortest way, then the earliest. */
const better = (a: Row, b: Row) =>
  b.foundShortest - a.foundShortest || (a.medianFirst ?? Infinity) - (b.medianFirst ?? Infinity)

/** The thesis's tuning grid, whole: which settings find a shortest way, and how early. */
export default function qThesis(): Table {
  const begun = performance.now()
  const { stdout, stderr, status } = spawnSync(process.execPath, [program, 'learn', 'q-thesis', '--json'], {
    encoding: 'utf8',
    maxBuffer: 1e9,
  })
  if (status !== 0) throw new Error(stderr)
  const seconds = (performance.now() - begun) / 1000
  const all = JSON.parse(stdout) as Row[]
  const rows = ['railway', 'forest', 'city'].flatMap((name) =>
    all
      .filter(({ map }) => map === name)
      .toSorted(better)
      .slice(0, shown)
      .map(({ map, alpha, gamma, nu, rho, runs, foundShortest, medianFirst }) =>
        [map, alpha, gamma, nu, rho, `${foundShortest} of ${runs}`, medianFirst ?? '–'].map(String),
      ),
  )
  return {
    title: "The thesis's tuning grid",
    how: '225 settings (α, γ, ν, ρ) × 50 runs × 3 maps by the study rules; railway 100 moves a run, forest 50, city 500. The best five settings of each map.',
    columns: ['map', 'α', 'γ', 'ν', 'ρ', 'runs that showed a shortest way', 'first after (median move)'],
    rows,
    notes: [
      `The whole grid: ${seconds.toFixed(1)} s on all cores, reading and starting included.`,
      'All rows: `npm run --silent botgarten -- learn q-thesis --csv FILE`.',
    ],
  }
}
