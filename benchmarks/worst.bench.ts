// One pupil does the worst, while another class on the same server works: `npm run load:worst`.
import { spawn, spawnSync } from 'node:child_process'
import { once } from 'node:events'
import { mkdtempSync, readFileSync, rmSync } from 'node:fs'
import { loadavg, setPriority, tmpdir } from 'node:os'
import { join } from 'node:path'
import { setTimeout as wait } from 'node:timers/promises'
import { ownSchema, startNode, type Client, type ServingNode } from '@botgarten/server/rehearsal'
import { percentile, type Table } from './bench.ts'
import { attacks, type AttackName } from './worst/attacks.ts'
import { startChildren, type Answered } from './worst/children.ts'
import { firstTeacher, openClass } from './worst/setting.ts'

const seconds = Number(process.env['BENCH_SECONDS'] ?? 35)
const postgres = process.env['BENCH_POSTGRES']
const pupils = 30
/** Linux can pin the server to one core, and the pupils and the attacker to the other. */
const isPinned = process.platform === 'linux'
const names = Object.keys(attacks) as AttackName[]
const wanted = process.env['BENCH_ONLY']?.split(';')

/** CPU time of a process so far, s; Linux counts in hundredths. */
function cpuOf({ process: { pid } }: ServingNode): number {
  if (!isPinned) return NaN
  const [, , , , , , , , , , , , , user, system] = readFileSync(`/proc/${pid}/stat`, 'utf8')
    .replace(/\(.*\)/, 'x')
    .split(' ')
  return (Number(user) + Number(system)) / 100
}

/** Other programs of the machine should not count: where this user may, server and pupils get a higher priority. */
const isFirst = isPinned && process.getuid?.() === 0

/** The attacker yields its core to the pupils that are measured: on two cores it would slow them, not the server. */
function startAttacker() {
  const script = join(import.meta.dirname, 'worst', 'attacker.ts')
  const prefix = isPinned ? ['taskset', '-c', '0', 'nice', '-n', isFirst ? '10' : '19'] : []
  const [first = '', ...args] = [...prefix, process.execPath, '--disable-warning=ExperimentalWarning', script]
  return spawn(first, args, { stdio: ['ignore', 'inherit', 'inherit', 'ipc'] })
}

interface Phase {
  readonly answered: readonly Answered[]
  /** CPU time of the server, of one core. */
  readonly cpu: number
}

interface Setting {
  readonly node: ServingNode
  readonly teacher: Client
  readonly children: Awaited<ReturnType<typeof startChildren>>
}

async function phase({ node, children }: Setting): Promise<Phase> {
  children.take()
  const before = cpuOf(node)
  await wait(seconds * 1000)
  return { answered: children.take(), cpu: (cpuOf(node) - before) / seconds }
}

async function attacked(setting: Setting, of: readonly AttackName[]) {
  const target = await openClass(setting.teacher, 'Attacked')
  const attacker = startAttacker()
  const ended = new AbortController()
  attacker.once('exit', () => ended.abort())
  const heard = async () => ((await once(attacker, 'message', { signal: ended.signal })) as [unknown])[0]
  const cookies = [...setting.teacher.cookies]
  attacker.send({ url: setting.node.url, class: target, cookies, attacks: of })
  await heard()
  attacker.send('start')
  // The burst of the beginning counts.
  const worst = await phase(setting)
  attacker.send('stop')
  const { sent, refused } = (await heard()) as { sent: number; refused: number }
  await wait(3000)
  return { ...worst, sent, refused }
}

const took = (phases: readonly Phase[], kind: Answered['kind']) =>
  phases.flatMap(({ answered }) => answered.filter((one) => one.kind === kind).map((one) => one.took))

const rounded = (value: number) => (value < 10 ? value.toFixed(1) : value.toFixed(0))

/** Cells of one kind of request: median and p99, each as `baseline → worst` and their ratio. */
function cells(calm: readonly Phase[], worst: Phase, kind: Answered['kind']): string[] {
  return [0.5, 0.99].flatMap((share) => {
    const [before, now] = [percentile(took(calm, kind), share), percentile(took([worst], kind), share)]
    return [`${rounded(before)} → ${rounded(now)} ms`, (now / before).toFixed(1)]
  })
}

async function rows(setting: Setting) {
  const all: (string | number)[][] = []
  let before = await phase(setting)
  const kinds = [...names.map((name) => [name, [name]] as const), ['all together', names] as const]
  for (const [title, of] of kinds.filter(([title]) => wanted?.includes(title) ?? true)) {
    const worst = await attacked(setting, of)
    const after = await phase(setting)
    const calm = [before, after]
    const failed = worst.answered.filter(({ isRefused }) => isRefused).length
    const saves = `${took([worst], 'save').length}${failed === 0 ? '' : ` (${failed} refused)`}`
    const cpu = `${((before.cpu + after.cpu) * 50).toFixed(0)} → ${(worst.cpu * 100).toFixed(0)} %`
    const sent = `${worst.refused} of ${worst.sent}`
    all.push([title, saves, ...cells(calm, worst, 'save'), ...cells(calm, worst, 'read'), cpu, sent])
    console.error(all.at(-1)!.join(' | '))
    before = after
  }
  return all
}

async function measured() {
  const data = mkdtempSync(join(tmpdir(), 'botgarten-worst-'))
  const schema = postgres === undefined ? null : await ownSchema(postgres, `worst_${process.pid}`)
  const prefix = isPinned ? ['taskset', '-c', '1'] : []
  const node = await startNode({ data, database: schema?.address, prefix })
  try {
    const teacher = await firstTeacher(node.url, node.token())
    const children = await startChildren(node.url, await openClass(teacher, 'Works'), pupils)
    // The first saves compile their code.
    await wait(10_000)
    const all = await rows({ node, teacher, children })
    await children.stop()
    return all
  } finally {
    await node.stop()
    await schema?.remove()
    rmSync(data, { recursive: true, force: true })
  }
}

export default async function worst(): Promise<Table> {
  if (isPinned) spawnSync('taskset', ['-cp', '0', String(process.pid)])
  // The server inherits it.
  if (isFirst) setPriority(-10)
  const saves = ['saves: median', 'ratio', 'p99', 'ratio']
  const reads = ['reads: median', 'ratio', 'p99', 'ratio']
  return {
    title: 'One pupil does the worst',
    how: `\`npm run load:worst -- --seconds ${seconds}\`: 30 pupils of one class save 60 kB every 5 s, report, read their list of projects and have a stream. A pupil of another class on the same server (exports: its teacher) does the worst for ${seconds} s; calm phases of the same length come before and after, and each value is compared with both of them together. The server is pinned to one core, with ${postgres === undefined ? 'SQLite, every commit on the disk' : 'PostgreSQL'}; pupils and attacker run on the other, where the attacker comes last.`,
    columns: ['one pupil', 'saves', ...saves, ...reads, 'CPU of the server', 'refused'],
    rows: await measured(),
    notes: [
      'Goal: each ratio at most 2.',
      `Load of the machine at the end, this included: ${loadavg()[1]!.toFixed(1)}.`,
    ],
  }
}
