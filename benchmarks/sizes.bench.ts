import { measure } from '../scripts/sizes.ts'
import { build } from '../scripts/prepare/build.mjs'
import { runQuietly } from '../scripts/prepare/run.mjs'
import type { Table } from './bench.ts'

const kB = (bytes: number) => (bytes / 1000).toFixed(1)

/** Scripts of pages and of features, and the files of the offline copy, one by one. */
export default async function sizes(): Promise<Table> {
  await build(runQuietly)
  const rows = measure().flatMap(({ what, files, bytes, budget }) => [
    [`**${what}**`, `**${kB(bytes)}**`, `**${kB(budget)}**`],
    ...files
      .filter((file) => file.bytes > 2000)
      .map(({ name, bytes }) => [`${what}: ${name}`, kB(bytes), '']),
  ])
  return {
    title: 'Sizes on the wire',
    how: 'Brotli files of a fresh build: the scripts in the HTML of a page and all that they import, and what the page asks for by itself. A part: what the lazy part of a feature adds to its page. The offline copy: all files that the service worker caches.',
    columns: ['page, feature or file', 'kB brotli', 'budget'],
    rows,
    notes: ['1 kB = 1000 bytes. Files under 2 kB are in the sums and not listed.'],
  }
}
