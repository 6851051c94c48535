import { spawnSync } from 'node:child_process'
import { join } from 'node:path'
import { stream } from '@botgarten/numbers'
import { isLong } from '@botgarten/numbers/testing'
import { describe, expect, it } from 'vitest'
import { inertiaByGroup, pointsOf, startAt, stepPhase, type Distance } from '../k-means/index.ts'
import { gridMap } from '../q-learning/grid.ts'
import {
  courseStream,
  createLearner,
  layOutWorld,
  run,
  type Settings as QSettings,
} from '../q-learning/index.ts'
import type { Activation, Brain } from '../neural-network/index.ts'
import {
  beginPractice,
  beginningOf,
  meanLoss,
  percentOff,
  practise,
  rowsOf,
  starter,
  type Settings,
} from '../neural-network/train/index.ts'
import { kMeansProof, mostNumbers, netProof, notebookOf, qProof, type Proof } from './index.ts'
import outputs from './reference/outputs.json' with { type: 'json' }

// ---- the proofs whose notebooks lie in reference/ ----

const layer = (name: string, size: number, activation: Activation) =>
  Array.from({ length: size }, (_, k) => ({ id: `${name}${k}`, activation, bias: 0 }))

const pairs = Array.from({ length: 12 }, (_, k) => ({
  inputs: [(k * 37) % 101, (k * 61) % 101],
  outputs: [((k * 37) % 101) - 20, 80 - ((k * 61) % 101)],
}))

/** A network that has practised so many rounds of 12 examples; the last four are held back where `keeps`. */
function practice(layers: Brain['layers'], settings: Partial<Settings>, keeps = false, shares = false) {
  const { weights } = beginningOf(layers, {}, 'zero', stream(7, 'learn/start/net'))
  const lit = ({ inputs }: (typeof pairs)[number]) => (inputs[0]! > inputs[1]! ? [100, -100] : [-100, 100])
  const rows = (of: typeof pairs) =>
    rowsOf(shares ? of.map((pair) => ({ ...pair, outputs: lit(pair) })) : of, { shares })
  const data = {
    layers,
    weights,
    practised: rows(keeps ? pairs.slice(0, 8) : pairs),
    kept: rows(keeps ? pairs.slice(8) : []),
  }
  return () => beginPractice({ ...starter, rounds: 1000, ...settings }, data, stream(7, 'learn/order/net'))
}

const plain = [layer('in', 2, 'identity'), layer('out', 2, 'identity')]
const deep = [
  layer('in', 2, 'identity'),
  layer('h', 4, 'tanh'),
  [...layer('a', 1, 'sigmoid'), ...layer('b', 1, 'identity')],
]
const lamps = [layer('in', 2, 'identity'), layer('h', 3, 'relu'), layer('out', 2, 'softmax')]

const nets = {
  net: { begin: practice(plain, {}), round: 60 },
  'net-momentum': {
    begin: practice(deep, { rate: 0.03, momentum: 0.9, batch: 5, bias: 'on', decay: 0.001 }, true),
    round: 40,
  },
  'net-adam': {
    begin: practice(deep, { optimizer: 'adam', rate: 0.01, batch: 4, bias: 'on', range: 'unit' }),
    round: 40,
  },
  'net-lamps': { begin: practice(lamps, { rate: 0.03, bias: 'on', order: 'table' }, false, true), round: 30 },
}

const world = layOutWorld(gridMap(['SFF', 'FWF', 'FFG'], { surefooted: 0.8 }))
const settings: QSettings = {
  ...{ rules: 'standard', algorithm: 'q', alpha: 0.5, gamma: 0.8, nu: 0.1, rho: 0.5 },
}
const kinds: { readonly [name: string]: QSettings } = {
  q: settings,
  'q-sarsa': {
    ...settings,
    algorithm: 'sarsa',
    alphaDecay: { kind: 'visits' },
    rhoDecay: { kind: 'episodes', factor: 0.9 },
  },
  'q-study': { ...settings, rules: 'study', alphaDecay: { kind: 'episodes', factor: 0.99 } },
}

const steps = 400
const learnerOf = (one: QSettings) => createLearner(world, one, courseStream(3))
/** The action that is worth most after these steps. */
function bestOf(one: QSettings): number {
  const learner = learnerOf(one)
  run(learner, steps)
  return learner.q.indexOf(Math.max(...learner.q))
}

const points = pointsOf(
  pairs.map(({ inputs, outputs }) => [...inputs.map((value) => value + 1), outputs[0]! / 2]),
)
const sortings = Object.fromEntries(
  (['euclidean', 'manhattan', 'cosine'] as const).map((distance) => [
    distance,
    // The last flag is so far away that no point is nearest to it.
    {
      points,
      distance,
      centres: [
        [10, 20, 5],
        [70, 20, 30],
        [distance === 'cosine' ? -900 : 900, 0, 0],
      ],
      rounds: 4,
    },
  ]),
)

const finished = (making: Generator<undefined, Proof>): Proof => {
  for (;;) {
    const { done, value } = making.next()
    if (done) return value
  }
}

const proofs: { readonly [name: string]: () => Proof } = {
  ...Object.fromEntries(
    Object.entries(nets).map(([name, { begin, round }]) => [name, () => finished(netProof(begin(), round))]),
  ),
  ...Object.fromEntries(
    Object.entries(kinds).map(([name, one]) => [name, () => qProof(learnerOf(one), steps, bestOf(one))]),
  ),
  ...Object.fromEntries(
    Object.entries(sortings).map(([distance, one]) => [`k-means-${distance}`, () => kMeansProof(one)!]),
  ),
}

const near = (value: number, other: number) =>
  expect(Math.abs(value - other)).toBeLessThanOrEqual(1e-9 * Math.max(1, Math.abs(other)))

describe('a notebook', () => {
  it.each(Object.keys(proofs))(
    'of %s is the one that was run, and NumPy has made its number',
    async (name) => {
      const proof = proofs[name]!()
      const notebook = notebookOf(proof, (part) => `*${part}*`)
      await expect(notebook).toMatchFileSnapshot(`./reference/${name}.ipynb`)
      const printed = (outputs as { readonly [name: string]: readonly string[] })[name]!
      near(Number(printed.at(-1)), proof.number)
    },
  )

  it('has a text before its data, before what learns and before the number, and a name for each cell', () => {
    const { nbformat, nbformat_minor, cells } = JSON.parse(
      notebookOf(proofs['q']!(), (part) => `*${part}*`),
    ) as {
      nbformat: number
      nbformat_minor: number
      cells: { id: string; cell_type: string; source: string[] }[]
    }
    expect([nbformat, nbformat_minor]).toEqual([4, 5])
    expect(cells.map(({ cell_type }) => cell_type)).toEqual([
      ...['markdown', 'markdown', 'code', 'markdown', 'code', 'markdown', 'code'],
    ])
    expect(new Set(cells.map(({ id }) => id)).size).toBe(cells.length)
    expect(cells[0]!.source).toEqual(['*title*'])
    expect(cells.flatMap(({ source }) => source).join('')).not.toContain('undefined')
  })

  // `npm run test:long` needs a python3 with NumPy.
  if (isLong)
    it('run now by plain Python, makes each number to 1e-9', () => {
      const { status, stdout, stderr } = spawnSync(
        'python3',
        [join(import.meta.dirname, 'reference/run.py')],
        {
          encoding: 'utf8',
        },
      )
      expect(status, stderr).toBe(0)
      const printed = JSON.parse(stdout) as typeof outputs
      expect(Object.keys(printed)).toEqual(Object.keys(outputs))
      for (const [name, make] of Object.entries(proofs))
        near(Number((printed as { readonly [name: string]: readonly string[] })[name]!.at(-1)), make().number)
    })
})

describe('a number', () => {
  it('of a network is the error of the round that is shown, however long it practised on', () => {
    const { begin, round } = nets['net-momentum']
    const practice = begin()
    const curve = practise(practice)
    near(
      finished(netProof(begin(), round)).number,
      percentOff(curve.find((point) => point.round === round)!.kept!),
    )
    expect(meanLoss(practice, practice.kept)).not.toBe(curve[round]!.kept)
  })

  it('of long practice begins later: a file does not hold all its draws', () => {
    const { begin } = nets.net
    const round = Math.floor(mostNumbers / 12) + 50
    const long = practice(plain, { rounds: 20_000 })
    const { data, number, before } = finished(netProof(long(), round))
    expect((data['orders'] as unknown[]).length).toBe(Math.floor(mostNumbers / 12))
    expect(before).toBe(50)
    expect(number).toBeLessThan(finished(netProof(begin(), 1)).number)
  })

  it('of a table is what the learner itself has after these steps', () => {
    const learner = learnerOf(settings)
    run(learner, steps)
    expect(proofs['q']!().number).toBe(Math.max(...learner.q))
  })

  it('of a long course begins with the table of then', () => {
    const many = 2 * mostNumbers
    const { data, number, before } = qProof(learnerOf(settings), many, 0)
    expect((data['steps'] as unknown[]).length).toBe(Math.floor(mostNumbers / 6))
    expect(before).toBe(many - Math.floor(mostNumbers / 6))
    const learner = learnerOf(settings)
    run(learner, many)
    expect(number).toBe(learner.q[0])
  })

  it('of a sorting is its last sum of distances, of which each group has a share', () => {
    for (const distance of ['euclidean', 'manhattan', 'cosine'] satisfies Distance[]) {
      const { centres, rounds } = sortings[distance]!
      let state = startAt(points, centres, distance)
      while (state.inertia.length < rounds && state.phase !== 'done') state = stepPhase(points, state)
      expect(kMeansProof(sortings[distance]!)!.number).toBe(state.inertia.at(-1))
      near(
        inertiaByGroup(points, state)!.reduce((sum, share) => sum + share, 0),
        state.inertia.at(-1)!,
      )
    }
  })

  it('of a table that is too large for a file has no notebook', () => {
    const many = pointsOf(Array.from({ length: mostNumbers / 2 + 1 }, (_, k) => [k, -k]))
    expect(kMeansProof({ points: many, centres: [[0, 0]], distance: 'euclidean', rounds: 1 })).toBeNull()
  })
})
