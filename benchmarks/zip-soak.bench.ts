// The unpacked zip of this Linux, as a teacher has it: a rehearsal, a class, and an hour of it compressed, on one core.
import { execFileSync, spawnSync } from 'node:child_process'
import { existsSync, mkdtempSync, readFileSync, rmSync, statSync } from 'node:fs'
import { loadavg, tmpdir } from 'node:os'
import { join } from 'node:path'
import { playLesson, startNode } from '@botgarten/server/rehearsal'
import { inHouse } from '../scripts/prepare/house.mjs'
import { unpack } from '../scripts/zips/unpack.ts'
import type { Table } from './bench.ts'

/** Of a class's row; the hour takes six times as long. */
const seconds = Number(process.env['BENCH_SECONDS'] ?? 120)
const pupils = 35
const [hold, ...toCore] = ['taskset', '-c', '1'] as const

const { version } = JSON.parse(readFileSync(inHouse('package.json'), 'utf8')) as { version: string }
const name = `botgarten-${version}-linux-${process.arch}`
const zip = inHouse('build', 'zips', `${name}.zip`)

const lessons = [
  { title: 'a class: a save every 5 s', every: 5, seconds },
  // 35 pupils save 25,200 times in an hour.
  { title: `an hour in ${(6 * seconds) / 60} minutes: a save every 1 s`, every: 1, seconds: 6 * seconds },
]

type Row = readonly (string | number)[]

interface Installed {
  /** The start script of the unpacked zip. */
  readonly program: string
  readonly data: string
  /** Nothing of it goes into the home folder of the person who measures. */
  readonly env: { readonly BOTGARTEN_DATA: string }
}

/** What the zip says of itself: it starts a server of its own, and ends it. Red is an answer, too. */
function rehearsed({ program, data, env }: Installed): Row {
  const options = ['--rehearse', `${pupils}`, '--seconds', '60', '--data', data, '--json']
  const { stdout } = spawnSync(hold, [...toCore, program, 'serve', ...options], {
    ...{ encoding: 'utf8', env: { ...process.env, ...env } },
  })
  const { saves, lost, p99, rss } = JSON.parse(stdout) as Record<'saves' | 'lost' | 'p99' | 'rss', number>
  return ['its own rehearsal of 60 s, pupils on the same core', saves, lost, `${p99} ms`, '', `${rss} MB`, '']
}

async function played({ program, data, env }: Installed, { title, ...lesson }: (typeof lessons)[number]) {
  const node = await startNode({ data, program, env, prefix: [hold, ...toCore] })
  try {
    const figures = await playLesson({ url: node.url, token: node.token(), pupils, ...lesson })
    const { saves, lost, p99, slowest, rss, rssFirst, rssLast } = figures
    const memory = [`${rss} MB`, `${rssFirst} → ${rssLast} MB`]
    return [title, saves, lost, `${p99} ms`, `${slowest} ms`, ...memory]
  } finally {
    await node.stop()
  }
}

/**
 * As after a restart of the computer: of a program that was just written Linux counts 40 MB more as the process's own. It
 * seems to take what is still in its cache in large pieces.
 */
const forgetProgram = (file: string) =>
  execFileSync('sh', ['-c', 'sync "$1"; dd if="$1" iflag=nocache count=0 status=none', 'sh', file])

/** A folder below one with blanks and umlauts, which is gone afterwards. */
async function inFolder<Result>(work: (folder: string) => Promise<Result>): Promise<Result> {
  const folder = mkdtempSync(join(tmpdir(), 'Übung 5b '))
  try {
    return await work(folder)
  } finally {
    rmSync(folder, { recursive: true, force: true })
  }
}

export default async function zipSoak(): Promise<Table> {
  if (!existsSync(zip)) throw new Error(`${zip} is missing: npm run zips -- linux-${process.arch}`)
  const rows = await inFolder(async (folder) => {
    unpack(zip, folder)
    forgetProgram(join(folder, name, 'node', 'node'))
    const env = { BOTGARTEN_DATA: join(folder, 'home') }
    const installed = (data: string): Installed => ({
      program: join(folder, name, 'botgarten.sh'),
      data: join(folder, data),
      env,
    })
    // Only the first start of a server compiles all of its code.
    await (await startNode(installed('first'))).stop()
    const made: Row[] = [rehearsed(installed('rehearsed'))]
    for (const [at, lesson] of lessons.entries()) made.push(await played(installed(`data ${at}`), lesson))
    return made
  })
  return {
    title: 'The installed zip on one core',
    how: `The zip of this Linux (${(statSync(zip).size / 1e6).toFixed(0)} MB) is unpacked into a folder with blanks and umlauts; its own start script and Node serve, pinned to one core. ${pupils} pupils with streams save 60 kB (one in twenty 1 MB) and report where they are, a teacher watches; but for the rehearsal they run on the other core.`,
    columns: ['lesson', 'saves', 'lost', 'p99', 'slowest', 'memory at most', 'first → last third'],
    rows,
    notes: [
      'Goals: nothing lost; at a save every 5 s p99 < 50 ms; at most 192 MB after an hour, flat. The hour’s row is about memory and losses: five times the load of a class.',
      `Load of the machine at the end, this included: ${loadavg()[1]!.toFixed(0)}.`,
    ],
  }
}
