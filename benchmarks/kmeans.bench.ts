import { spawnSync } from 'node:child_process'
import { join } from 'node:path'
import { cluster, pointsOf, randomStart } from '@botgarten/learning/k-means'
import { draw, stream } from '@botgarten/numbers'
import { median, type Table } from './bench.ts'

const [count, groups, rounds] = [10_000, 5, 20]

/** Five round heaps on a plane; `wide` against the distance between them. The wider, the more rounds it takes. */
function task(wide: number) {
  const chance = stream(1, 'benchmark')
  const near = () => wide * (draw(chance) + draw(chance) + draw(chance) + draw(chance) - 2)
  const points = Array.from({ length: count }, (_, point) => {
    const heap = point % groups
    return [(heap % 3) + near(), Math.floor(heap / 3) + near()]
  })
  return { points, start: randomStart(pointsOf(points), groups, stream(2, 'benchmark')) }
}

type Task = ReturnType<typeof task>

function ours({ points, start }: Task) {
  const all = pointsOf(points)
  let found = cluster(all, start)
  const before = process.threadCpuUsage()
  for (let round = 0; round < rounds; round++) found = cluster(all, start)
  const { user, system } = process.threadCpuUsage(before)
  return { ...found, ms: (user + system) / 1000 / rounds / found.iterations }
}

function theirs(given: Task): { ms: number; iterations: number; labels: number[] } {
  const program = join(import.meta.dirname, 'k-means/peer.py')
  const { status, stdout, stderr } = spawnSync(process.env['PYTHON'] ?? 'python3', [program, `${rounds}`], {
    input: JSON.stringify(given),
    encoding: 'utf8',
  })
  if (status !== 0) throw new Error(stderr)
  return JSON.parse(stdout) as ReturnType<typeof theirs>
}

function onceEach(given: Task) {
  const [here, there] = [ours(given), theirs(given)]
  const unlike = here.labels.filter((label, point) => label !== there.labels[point]).length
  if (unlike > 0 || here.iterations !== there.iterations) throw new Error(`${unlike} points are elsewhere.`)
  return { here: here.ms, there: there.ms, iterations: here.iterations }
}

function rowsFor(name: string, wide: number): (string | number)[][] {
  const given = task(wide)
  const runs = Array.from({ length: 5 }, () => onceEach(given))
  const [here, there] = [median(runs.map((run) => run.here)), median(runs.map((run) => run.there))]
  const { iterations } = runs[0]!
  return [
    [name, iterations, 'this', here.toFixed(3), `${(here / there).toFixed(2)} ×`, '≤ 1 ×'],
    [name, iterations, 'scikit-learn, k_means, lloyd', there.toFixed(3), '', ''],
  ]
}

/** An iteration beside scikit-learn's. */
export default function kMeans(): Table {
  return {
    title: 'k-means on 10,000 points',
    how: `2 features, ${groups} groups, the same start until no point changes; milliseconds of processor time an iteration on one thread, median of 5 rounds in which each takes its turn.`,
    columns: ['points', 'iterations', 'what', 'ms an iteration', 'ours to it', 'goal'],
    rows: [...rowsFor('heaps apart', 0.3), ...rowsFor('heaps that touch', 0.5), ...rowsFor('one cloud', 1)],
    notes: [
      'Groups of all points and the number of iterations are equal, or the run ends with an error.',
      'scikit-learn is taken from the Python that PYTHON names.',
    ],
  }
}
