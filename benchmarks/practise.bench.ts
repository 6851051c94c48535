import { spawnSync } from 'node:child_process'
import { mkdtempSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { pathToFileURL } from 'node:url'
import type { Brain, Weights } from '@botgarten/learning/neural-network'
import { learner } from '@botgarten/learning/neural-network'
import { rowsOf, starter, stepSome } from '@botgarten/learning/neural-network/train'
import { draw, stream } from '@botgarten/numbers'
import { median, type Table } from './bench.ts'

const here = join(import.meta.dirname, 'practise')
const sizes = [4, 8, 2] as const
const rows = 512

type Curve = 'relu' | 'tanh'

const dice = stream(23, 'bench')
const between = (least: number, most: number) => least + (most - least) * draw(dice)
const pairs = Array.from({ length: rows }, () => ({
  inputs: Array.from({ length: 4 }, () => Math.round(between(0, 100))),
  outputs: Array.from({ length: 2 }, () => Math.round(between(-100, 100))),
}))

const layersFor = (curve: Curve): Brain['layers'] =>
  sizes.map((size, l) =>
    Array.from({ length: size }, (_, k) => ({
      ...{ id: `n${l}.${k}`, bias: 0 },
      activation: l === 1 ? curve : ('identity' as const),
    })),
  )

const weights: Weights = Object.fromEntries(
  [0, 1].flatMap((l) =>
    Array.from({ length: sizes[l]! }, (_, from) => [
      `n${l}.${from}`,
      Object.fromEntries(
        Array.from({ length: sizes[l + 1]! }, (_, to) => [`n${l + 1}.${to}`, between(-0.5, 0.5)]),
      ),
    ]),
  ),
)

function begun(curve: Curve, batch: number, rounds: number) {
  const settings = {
    ...starter,
    rate: 0.03,
    momentum: 0.9,
    batch,
    rounds,
    bias: 'on',
    order: 'table',
  } as const
  const none = rowsOf([])
  const data = { layers: layersFor(curve), weights, practised: rowsOf(pairs), kept: none }
  return learner.begin(settings, data, stream(1, 'bench'))
}

/** Examples a second of processor time, and the parameters at the end. */
function ours(curve: Curve, batch: number, rounds: number): readonly number[] {
  const practice = begun(curve, batch, rounds)
  const before = process.threadCpuUsage()
  while (practice.ended === null) stepSome(practice)
  const { user, system } = process.threadCpuUsage(before)
  return [(1e6 * rounds * rows) / (user + system), ...practice.parameters]
}

/** What a peer reads: parameters as both begin, then the rows in hundredths. */
function numbersFor(curve: Curve): string {
  const { parameters, practised } = begun(curve, 1, 1)
  const lines = pairs.map((_, row) => [
    ...practised.inputs.subarray(row * 4, row * 4 + 4),
    ...practised.targets.subarray(row * 2, row * 2 + 2),
  ])
  return [...parameters, ...lines.flat()].join(' ')
}

function run(command: string, args: readonly string[], input = ''): string {
  const { status, stdout, stderr } = spawnSync(command, args, { input, encoding: 'utf8' })
  if (status !== 0) throw new Error(`${command} ${args.join(' ')}: ${stderr}`)
  return stdout
}

function compiled(): string {
  const program = join(mkdtempSync(join(tmpdir(), 'botgarten-c-')), 'loop')
  run('cc', ['-O2', join(here, 'loop.c'), '-lm', '-o', program])
  return program
}

type Work = (curve: Curve, batch: number, rounds: number) => readonly number[]

const peer =
  (command: string, ...first: readonly string[]): Work =>
  (curve, batch, rounds) =>
    run(command, [...first, curve, String(batch), String(rounds)], numbersFor(curve))
      .trim()
      .split(' ')
      .map(Number)

/** After ten rounds a peer must have our parameters, or it did other work. */
function farthest(work: Work, curve: Curve, batch: number): number {
  const [, ...own] = ours(curve, batch, 10)
  const [, ...theirs] = work(curve, batch, 10)
  return Math.max(...own.map((value, k) => Math.abs(value - theirs[k]!)))
}

/** What TensorFlow Playground's engine, src/nn.ts, has to know. */
interface Playground {
  buildNetwork(
    shape: number[],
    hidden: unknown,
    output: unknown,
    regularization: null,
    inputs: string[],
  ): unknown
  forwardProp(network: unknown, inputs: number[]): number
  backProp(network: unknown, target: number, error: unknown): void
  updateWeights(network: unknown, rate: number, regularizationRate: number): void
  readonly Activations: { readonly RELU: unknown; readonly TANH: unknown; readonly LINEAR: unknown }
  readonly Errors: { readonly SQUARE: unknown }
}

/** Its examples a second: the same rows, one output, no momentum; it has neither more outputs nor that. */
async function playground(path: string): Promise<Work> {
  const nn = (await import(pathToFileURL(path).href)) as Playground
  const table = pairs.map(({ inputs, outputs }) => ({
    inputs: inputs.map((value) => value / 100),
    target: outputs[0]! / 100,
  }))
  return (curve, batch, rounds) => {
    const { RELU, TANH, LINEAR } = nn.Activations
    const network = nn.buildNetwork([4, 8, 1], curve === 'relu' ? RELU : TANH, LINEAR, null, [...'abcd'])
    const before = process.threadCpuUsage()
    for (let round = 0; round < rounds; round++)
      table.forEach(({ inputs, target }, row) => {
        nn.forwardProp(network, inputs)
        nn.backProp(network, target, nn.Errors.SQUARE)
        if ((row + 1) % batch === 0) nn.updateWeights(network, 0.03, 0)
      })
    const { user, system } = process.threadCpuUsage(before)
    return [(1e6 * rounds * rows) / (user + system)]
  }
}

const million = (speed: number) => `${(speed / 1e6).toPrecision(3)} M`

/** How fast a network practises beside the same loop in C and beside PyTorch. */
export default async function practise(): Promise<Table> {
  const c = peer(compiled())
  const torch = peer(process.env['PYTHON'] ?? 'python3', join(here, 'loop.py'))
  const races: [string, Work, Curve, number, number, number][] = [
    ['C, -O2: the same loop', c, 'relu', 16, 400, 0.5],
    ['C, -O2: the same loop', c, 'tanh', 16, 400, 0.35],
    ['PyTorch, float64, one thread', torch, 'relu', 16, 20, 10],
    ['PyTorch, float64, one thread', torch, 'relu', 512, 200, 1],
  ]
  const { PLAYGROUND } = process.env
  const other = PLAYGROUND === undefined ? null : await playground(PLAYGROUND)
  if (other)
    for (const curve of ['relu', 'tanh'] as const)
      races.push(['TensorFlow Playground, nn.ts', other, curve, 16, 20, 3])
  const lines = races.map(([name, work, curve, batch, rounds, least]) => {
    const off = work === other ? null : farthest(work, curve, batch)
    if (off !== null && !(off < 1e-9)) throw new Error(`${name} learned something else: ${off}`)
    const speeds: [number[], number[]] = [[], []]
    for (let round = 0; round < 5; round++) {
      speeds[0].push(ours(curve, batch, 400)[0]!)
      speeds[1].push(work(curve, batch, rounds)[0]!)
    }
    const [own, theirs] = speeds.map(median)
    return [
      ...[curve, batch, name, million(own!), million(theirs!)],
      ...[`${(own! / theirs!).toPrecision(3)} ×`, `≥ ${least} ×`, off?.toExponential(1) ?? '–'],
    ]
  })
  return {
    title: 'Practice of a network',
    how: 'Examples a second of processor time on one core, 4-8-2 with momentum over 512 rows; the median of five rounds in which each takes its turn.',
    columns: ['activation', 'batch', 'beside', 'ours', 'its', 'ours to it', 'goal', 'Δw after 10 rounds'],
    rows: lines,
    notes: [
      'C has the sizes of the network at compile time, so that its loops are unrolled; ours takes any network.',
      'PyTorch is taken from the Python that PYTHON names, TensorFlow Playground’s nn.ts from the path in PLAYGROUND; it has one output and no momentum.',
    ],
  }
}
