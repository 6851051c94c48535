// A class of 35 on a server that has one core: how long saves take, and what the process holds.
import { mkdtempSync, rmSync } from 'node:fs'
import { loadavg, tmpdir } from 'node:os'
import { join } from 'node:path'
import { playLesson, startNode } from '@botgarten/server/rehearsal'
import type { Table } from './bench.ts'

const seconds = Number(process.env['BENCH_SECONDS'] ?? 120)
/** Linux can hold a process to one core. */
const prefix = process.platform === 'linux' ? ['taskset', '-c', '1'] : []
const slowDisk = [`--import=${import.meta.resolve('@botgarten/classroom/testing/slow-disk')}`]

interface Lesson {
  readonly title: string
  /** Between two saves of a pupil, and for how long, s. */
  readonly every: number
  readonly seconds: number
  readonly flags?: readonly string[]
}

const lessons: readonly Lesson[] = [
  { title: 'a save every 5 s', every: 5, seconds },
  { title: 'the same, each wait for the disk 30 ms longer', every: 5, seconds, flags: slowDisk },
  // 35 pupils save 25,200 times in an hour.
  { title: 'an hour in 12 minutes: a save every 1 s', every: 1, seconds: 6 * seconds },
]

async function played({ every, seconds, flags = [] }: Lesson) {
  const data = mkdtempSync(join(tmpdir(), 'botgarten-bench-'))
  const node = await startNode({ data, prefix, flags })
  try {
    return await playLesson({ url: node.url, token: node.token(), pupils: 35, seconds, every })
  } finally {
    await node.stop()
    rmSync(data, { recursive: true, force: true })
  }
}

async function rowOf(lesson: Lesson) {
  const { saves, lost, p99, slowest, rss, rssFirst, rssLast } = await played(lesson)
  const memory = [`${rss} MB`, `${rssFirst} → ${rssLast} MB`]
  return [lesson.title, saves, lost, `${p99} ms`, `${slowest} ms`, ...memory]
}

/** Only the first start of a server strips the types of its sources, which takes memory. */
async function startOnce() {
  const data = mkdtempSync(join(tmpdir(), 'botgarten-bench-'))
  await (await startNode({ data })).stop()
  rmSync(data, { recursive: true, force: true })
}

export default async function classRoom(): Promise<Table> {
  await startOnce()
  const rows = []
  for (const lesson of lessons) rows.push(await rowOf(lesson))
  return {
    title: 'A class of 35 on one core',
    how: '35 pupils with streams save 60 kB (one in twenty 1 MB, each at a time of its own) and report where they are, a teacher watches. The server, not started for the first time, is one process pinned to a core, SQLite with every commit on the disk; the pupils run on the other core.',
    columns: ['lesson', 'saves', 'lost', 'p99', 'slowest', 'memory at most', 'first → last third'],
    rows,
    notes: [
      'Goals: at a save every 5 s p99 < 50 ms, with the slow disk < 200 ms; at most 192 MB after an hour, flat. Times are those of the pupil: sending, checking, committing, answering. An hour’s row is about memory: five times the load of a class.',
      `Load of the machine at the end, this included: ${loadavg()[1]!.toFixed(0)}.`,
    ],
  }
}
