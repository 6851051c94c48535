import { content } from '@botgarten/content/files'
import { spawnSync } from 'node:child_process'
import { mkdtempSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import {
  createLearner,
  layOutWorld,
  run,
  step,
  type QLearner,
  type QWorld,
  type Settings,
} from '@botgarten/learning/q-learning'
import { median, type Table } from './bench.ts'

const here = join(import.meta.dirname, 'q-learning')
const settings: Settings = { rules: 'standard', algorithm: 'q', alpha: 0.5, gamma: 0.8, nu: 0.1, rho: 0.5 }
const moves = 20_000_000

function city(): QWorld {
  return layOutWorld({ map: content.mapFile('city')!.map, start: 0, goal: 15, closed: [[16, 15]] })
}

const fresh = (world: QWorld) => createLearner(world, settings, [1, 2, 3, 4])

function perSecond(world: QWorld, count: number, work: (learner: QLearner) => void): number {
  const learner = fresh(world)
  const before = process.threadCpuUsage()
  work(learner)
  const { user, system } = process.threadCpuUsage(before)
  return (1e6 * count) / (user + system)
}

const fast = (world: QWorld) => perSecond(world, moves, (learner) => run(learner, moves))

function traced(world: QWorld): number {
  const count = moves / 10
  let sum = 0
  const speed = perSecond(world, count, (learner) => {
    for (let move = 0; move < count; move++) sum += step(learner).after
  })
  if (!(sum > 0)) throw new Error('Nothing was learned.')
  return speed
}

const graphOf = ({ states: stations, start, goal, first, to }: QWorld) =>
  [stations, start, goal, ...first, ...to].join(' ')

function peer(command: string, args: readonly string[], world: QWorld): string {
  const { status, stdout, stderr } = spawnSync(command, args, { input: graphOf(world), encoding: 'utf8' })
  if (status !== 0) throw new Error(`${command} ${args.join(' ')}: ${stderr}`)
  return stdout
}

/** The C loop, compiled now; its table must be ours to the last bit, or it did other work. */
function inC(world: QWorld): () => number {
  const program = join(mkdtempSync(join(tmpdir(), 'botgarten-c-')), 'loop')
  peer('cc', ['-O2', join(here, 'loop.c'), '-o', program], world)
  return () => {
    const [speed, ...q] = peer(program, [String(moves)], world)
      .trim()
      .split(' ')
      .map(Number)
    const learner = fresh(world)
    run(learner, moves)
    if (q.some((value, index) => value !== learner.q[index]))
      throw new Error('The C loop learned other values.')
    return speed!
  }
}

const python = (method: string, world: QWorld) => () =>
  Number(peer(process.env['PYTHON'] ?? 'python3', [join(here, 'loop.py'), method, '300000'], world))

const million = (speed: number) => `${(speed / 1e6).toPrecision(3)} M`

/** How fast Q-learning runs beside the same loop in C and Python. */
export default function qLearning(): Table {
  const world = city()
  const works: [string, () => number, number | null][] = [
    ['this, untraced', () => fast(world), null],
    ['this, every move traced', () => traced(world), null],
    ['C, -O2: same generator, same table, equal values', inC(world), 0.4],
    ['NumPy, a world that steps as in Gymnasium', python('numpy', world), 100],
    ['plain Python', python('plain', world), 20],
  ]
  const speeds = works.map(() => [] as number[])
  for (let round = 0; round < 5; round++) works.forEach(([, work], index) => speeds[index]!.push(work()))
  const medians = speeds.map(median)
  const rows = works.map(([name, , least], index) => [
    name,
    million(medians[index]!),
    index < 2 ? '' : `${(medians[0]! / medians[index]!).toPrecision(3)} ×`,
    index === 1 ? '≥ 1 M a second' : least === null ? '' : `≥ ${least} ×`,
  ])
  return {
    title: 'Q-learning on the City',
    how: 'Moves (updates) a second of processor time on one core; the median of five rounds in which each takes its turn.',
    columns: ['what', 'moves a second', 'ours to it', 'goal'],
    rows,
    notes: [
      '20 stations, 67 roads, standard rules: α 0.5, γ 0.8, ν 0.1, ρ 0.5.',
      'NumPy is taken from the Python that PYTHON names.',
    ],
  }
}
