import { launchBrowser } from '../e2e/browser.ts'
import { outcomesIn } from '../e2e/runs/in-browser.ts'
import { names, outcomes } from '../e2e/runs/runs.ts'
import type { Table } from './bench.ts'

const said = (equal: boolean) => (equal ? 'equal' : '**not equal**')

/** Hashes of twenty programs, pushing included, in Node and in Chromium. */
export default async function equality(): Promise<Table> {
  const browser = await launchBrowser()
  const there = await outcomesIn(await browser.newPage(), names)
  await browser.close()
  const rows = outcomes(names).map(({ name, hash, restored, pushed }, index) => [
    ...[name, pushed ? 'yes' : 'no', `\`${hash}\``],
    ...[said(there[index]?.hash === hash), said(restored === hash && there[index]?.restored === hash)],
  ])
  return {
    title: 'The same run everywhere',
    how: 'Twenty programs of one minute each in worlds full of things to push; the hash is over x, y, heading at every tick.',
    columns: ['program', 'pushed', 'hash in Node', 'Chromium', 'restored in the middle'],
    rows,
  }
}
