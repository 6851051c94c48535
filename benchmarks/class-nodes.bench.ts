// Several servers on one PostgreSQL behind a round-robin proxy: saves a second, CPU a save, and a node killed in the middle.
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { loadavg, tmpdir } from 'node:os'
import { join } from 'node:path'
import { openPostgres } from '@botgarten/classroom'
import { fillClasses } from '@botgarten/classroom/testing/many-classes'
import { startPostgres } from '@botgarten/classroom/testing/postgres'
import { playLesson, startNode, type ServingNode } from '@botgarten/server/rehearsal'
import type { Table } from './bench.ts'
import { heldTo } from './held.ts'
import { roundRobin } from './proxy.ts'

const seconds = Number(process.env['BENCH_SECONDS'] ?? 40)
const pupils = 35
const classes = 1000
/** Of a core, for each node: three of them, PostgreSQL and the pupils find room on two cores. */
const share = 0.2

/** CPU time of a process so far, ms; Linux counts in hundredths. */
function cpuOf({ process: { pid } }: ServingNode): number {
  const [, , , , , , , , , , , , , user, system] = readFileSync(`/proc/${pid}/stat`, 'utf8')
    .replace(/\(.*\)/, 'x')
    .split(' ')
  return (Number(user) + Number(system)) * 10
}

async function fill(address: string) {
  const database = openPostgres(address)
  await fillClasses(database, classes)
  await database.close()
}

/** A node that may be killed and started again. */
async function nodeAt(at: number, folder: string, database: string) {
  const held = heldTo(share, `node-${at}`)
  const options = {
    ...{ data: join(folder, `node-${at}`), database, prefix: held?.prefix ?? [] },
    env: { BOTGARTEN_KEY: join(folder, 'shared.key') },
  }
  let node = await startNode(options)
  return {
    isHeld: held !== null,
    get node() {
      return node
    },
    async fails() {
      const { port } = node
      await node.kill()
      node = await startNode({ ...options, port })
    },
    async stop() {
      await node.stop()
      held?.close()
    },
  }
}

async function measured(count: number, killed: boolean) {
  const folder = mkdtempSync(join(tmpdir(), 'botgarten-nodes-'))
  const postgres = await startPostgres({ fsync: true })
  const database = await postgres.newDatabase()
  await fill(database)
  writeFileSync(join(folder, 'shared.key'), Buffer.alloc(32, 7))
  const nodes: Awaited<ReturnType<typeof nodeAt>>[] = []
  for (let at = 0; at < count; at++) nodes.push(await nodeAt(at, folder, database))
  const proxy = await roundRobin(nodes.map(({ node }) => node.port))
  const before = nodes.map(({ node }) => cpuOf(node))
  let failing: Promise<unknown> = Promise.resolve()
  const kill = () => {
    failing = nodes[1]!.fails()
  }
  if (killed) setTimeout(kill, (seconds * 1000) / 2)
  // The newest link for the first teacher is that of the last node.
  const token = nodes.at(-1)!.node.token()
  const figures = await playLesson({ url: proxy.url, token, pupils, seconds, every: 0.2 })
  await failing
  const cpu = killed ? null : nodes.reduce((sum, { node }, at) => sum + cpuOf(node) - before[at]!, 0)
  proxy.close()
  for (const node of nodes) await node.stop()
  await postgres.stop()
  rmSync(folder, { recursive: true, force: true })
  return { ...figures, cpu, isHeld: nodes.every(({ isHeld }) => isHeld) }
}

export default async function classNodes(): Promise<Table> {
  const rows = []
  let isHeld = true
  for (const [name, count, killed] of [
    ['one node', 1, false],
    ['three nodes', 3, false],
    ['three nodes, one killed in the middle and started again', 3, true],
  ] as const) {
    const figures = await measured(count, killed)
    const { saves, lost, again, p99, cpu } = figures
    isHeld &&= figures.isHeld
    const each = cpu === null ? '' : `${(cpu / saves).toFixed(1)} ms`
    rows.push([name, saves, (saves / seconds).toFixed(0), each, `${p99} ms`, lost, again])
  }
  const bound = isHeld
    ? `Each node is held to ${share * 100} % of a core by a control group, so that they and not the machine are the bound. Goal: three give at least twice as much as one.`
    : 'Pupils, proxy, nodes and PostgreSQL share the cores of this machine, which bound the saves a second. CPU a save is what the nodes alone take.'
  return {
    title: 'Several servers on one PostgreSQL',
    how: `${pupils} pupils save 60 kB (one in twenty 1 MB) five times a second as far as they are answered, through a proxy that gives each request to the next node, for ${seconds} s; PostgreSQL waits for the disk and holds ${classes} other classes: 25,000 pupils, 500,000 versions.`,
    columns: ['', 'saves', 'a second', 'CPU a save', 'p99', 'lost', 'sent again'],
    rows,
    notes: [bound, `Load of the machine at the end, this included: ${loadavg()[1]!.toFixed(0)}.`],
  }
}
