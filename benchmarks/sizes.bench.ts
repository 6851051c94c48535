import { measure } from '../scripts/sizes.ts'
import { build } from '../scripts/prepare/build.mjs'
import { runQuietly } from '../scripts/prepare/run.mjs'
import type { Table } from './bench.ts'

const kB = (bytes: number) => (bytes / 1000).toFixed(1)

/** JavaScript of pages and of features, chunk by chunk. */
export default async function sizes(): Promise<Table> {
  await build(runQuietly)
  const rows = measure().flatMap(({ what, scripts, bytes, budget }) => [
    [`**${what}**`, `**${kB(bytes)}**`, `**${kB(budget)}**`],
    ...scripts
      .filter((script) => script.bytes > 2000)
      .map(({ name, bytes }) => [`${what}: ${name}`, kB(bytes), '']),
  ])
  return {
    title: 'JavaScript on the wire',
    how: 'Brotli files of a fresh build: the scripts in the HTML of a page and all that they import, and what the page asks for by itself. A part: what the lazy part of a feature adds to its page.',
    columns: ['page, feature or chunk', 'kB brotli', 'budget'],
    rows,
    notes: ['1 kB = 1000 bytes. Chunks under 2 kB are in the sums and not listed.'],
  }
}
