// Several servers on one PostgreSQL behind a round-robin proxy: CPU a save, and a node killed in the middle.
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { startPostgres } from '@botgarten/classroom/testing/postgres'
import { playLesson, startNode, type ServingNode } from '@botgarten/server/rehearsal'
import type { Table } from './bench.ts'
import { roundRobin } from './proxy.ts'

const seconds = Number(process.env['BENCH_SECONDS'] ?? 40)
const pupils = 35

/** CPU time of a process so far, ms; Linux counts in hundredths. */
function cpuOf({ process: { pid } }: ServingNode): number {
  const [, , , , , , , , , , , , , user, system] = readFileSync(`/proc/${pid}/stat`, 'utf8')
    .replace(/\(.*\)/, 'x')
    .split(' ')
  return (Number(user) + Number(system)) * 10
}

async function measured(count: number, killed: boolean) {
  const folder = mkdtempSync(join(tmpdir(), 'botgarten-nodes-'))
  const postgres = await startPostgres({ fsync: true })
  const database = await postgres.newDatabase()
  const key = join(folder, 'shared.key')
  writeFileSync(key, Buffer.alloc(32, 7))
  const env = { BOTGARTEN_KEY: key }
  const nodes: ServingNode[] = []
  for (let at = 0; at < count; at++)
    nodes.push(await startNode({ data: join(folder, `node-${at}`), database, env }))
  const proxy = await roundRobin(nodes.map(({ port }) => port))
  const before = nodes.map(cpuOf)
  let victim: Promise<unknown> = Promise.resolve()
  if (killed)
    setTimeout(
      () => {
        const { port } = nodes[1]!
        victim = nodes[1]!.kill().then(async () => {
          nodes[1] = await startNode({ data: join(folder, 'node-1'), database, env, port })
        })
      },
      (seconds * 1000) / 2,
    )
  // The newest link for the first teacher is that of the last node.
  const figures = await playLesson({
    url: proxy.url,
    token: nodes.at(-1)!.token(),
    pupils,
    seconds,
    every: 0.2,
  })
  await victim
  const cpu = killed ? null : nodes.reduce((sum, node, at) => sum + cpuOf(node) - before[at]!, 0)
  proxy.close()
  for (const node of nodes) await node.stop()
  await postgres.stop()
  rmSync(folder, { recursive: true, force: true })
  return { ...figures, cpu }
}

export default async function classNodes(): Promise<Table> {
  const rows = []
  for (const [name, count, killed] of [
    ['one node', 1, false],
    ['three nodes', 3, false],
    ['three nodes, one killed in the middle and started again', 3, true],
  ] as const) {
    const { saves, lost, again, p99, cpu } = await measured(count, killed)
    const each = cpu === null ? '' : `${(cpu / saves).toFixed(1)} ms`
    rows.push([name, saves, (saves / seconds).toFixed(0), each, `${p99} ms`, lost, again])
  }
  return {
    title: 'Several servers on one PostgreSQL',
    how: `${pupils} pupils save 60 kB (one in twenty 1 MB) five times a second as far as they are answered, through a proxy that gives each request to the next node, for ${seconds} s; PostgreSQL waits for the disk.`,
    columns: ['', 'saves', 'a second', 'CPU a save', 'p99', 'lost', 'sent again'],
    rows,
    notes: [
      'Pupils, proxy, nodes and PostgreSQL share the cores of this machine, which bound the saves a second. CPU a save is what the nodes alone take.',
    ],
  }
}
