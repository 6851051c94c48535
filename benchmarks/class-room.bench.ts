// A class of 35 on a server that has one core: how long saves take, and what the process holds.
import { mkdtempSync, rmSync } from 'node:fs'
import { loadavg, tmpdir } from 'node:os'
import { join } from 'node:path'
import { playLesson, startNode } from '@botgarten/server/rehearsal'
import type { Table } from './bench.ts'

const seconds = Number(process.env['BENCH_SECONDS'] ?? 120)
/** Linux can hold a process to one core. */
const prefix = process.platform === 'linux' ? ['taskset', '-c', '1'] : []

async function lesson(every: number) {
  const data = mkdtempSync(join(tmpdir(), 'botgarten-bench-'))
  const node = await startNode({ data, prefix })
  try {
    return await playLesson({ url: node.url, token: node.token(), pupils: 35, seconds, every })
  } finally {
    await node.stop()
    rmSync(data, { recursive: true, force: true })
  }
}

export default async function classRoom(): Promise<Table> {
  const rows = []
  for (const every of [5, 1]) {
    const { saves, lost, p99, slowest, rss, rssFirst, rssLast } = await lesson(every)
    rows.push([
      `${every} s`,
      saves,
      lost,
      `${p99} ms`,
      `${slowest} ms`,
      `${rss} MB`,
      `${rssFirst} → ${rssLast} MB`,
    ])
  }
  return {
    title: 'A class of 35 on one core',
    how: `35 pupils with streams save 60 kB (one in twenty 1 MB) and report where they are, a teacher watches, for ${seconds} s. The server is one process pinned to a core, SQLite with every commit on the disk; the pupils run on the other core.`,
    columns: ['a save every', 'saves', 'lost', 'p99', 'slowest', 'memory at most', 'first → last third'],
    rows,
    notes: [
      'Goals: p99 < 50 ms and at most 192 MB at a save every 5 s, flat. Times are those of the pupil: sending, checking, committing, answering.',
      `Load of the machine at the end, this included: ${loadavg()[1]!.toFixed(0)}.`,
    ],
  }
}
