import type { Activation, Brain } from '@botgarten/learning/neural-network'
import {
  beginningOf,
  beginPractice,
  meanLoss,
  rowsOf,
  starter,
  stepSome,
  type Settings,
} from '@botgarten/learning/neural-network/train'
import { stream } from '@botgarten/numbers'
import type { Table } from './bench.ts'

const seeds = 50
/** Of the loss: further off, and an answer is on the wrong side of 0 somewhere. */
const solved = 0.1

/** Red and blue of the floor: go where exactly one of them is bright. */
const eitherOr = [
  [70, 2, 100],
  [5, 65, 100],
  [100, 100, -100],
  [0, 0, -100],
  [68, 4, 100],
  [3, 66, 100],
  [97, 97, -100],
  [3, 2, -100],
].map(([red, blue, wish]) => ({ inputs: [red!, blue!], outputs: [wish!] }))

const layersOf = (hidden: number, activation: Activation): Brain['layers'] =>
  [2, hidden, 1].map((size, l) =>
    Array.from({ length: size }, (_, k) => ({
      ...{ id: `n${l}.${k}`, bias: 0 },
      activation: l === 1 ? activation : ('identity' as const),
    })),
  )

type Outcome = 'learned' | 'ranAway' | 'stuck'

/** 400 rounds from zero with this seed. */
function outcomeOf(layers: Brain['layers'], settings: Settings, seed: number): Outcome {
  const { weights } = beginningOf(layers, {}, 'zero', stream(seed, 'learn/start/net'))
  const data = { layers, weights, practised: rowsOf(eitherOr), kept: rowsOf([]) }
  const practice = beginPractice(settings, data, stream(seed, 'learn/order/net'))
  while (practice.ended === null) stepSome(practice)
  if (practice.ended.kind === 'ranAway') return 'ranAway'
  return meanLoss(practice, practice.practised)! < solved ? 'learned' : 'stuck'
}

function counted(layers: Brain['layers'], settings: Settings): string {
  const all = Array.from({ length: seeds }, (_, seed) => outcomeOf(layers, settings, seed + 1))
  const count = (outcome: Outcome) => all.filter((one) => one === outcome).length
  const away = count('ranAway')
  return away === 0 ? `${count('learned')}` : `${count('learned')}, ${away} ran away`
}

const base: Settings = { ...starter, momentum: 0.9, batch: 4, rounds: 400, bias: 'on' }
const rates = [0.003, 0.01, 0.03, 0.1, 0.3, 1] as const

/** From how many of 50 seeds a network learns either-or: by activation, size and learning rate. */
export default function seedsTable(): Table {
  const lines = (['relu', 'tanh', 'sigmoid'] as const).flatMap((activation) =>
    [2, 3, 4, 6].map((hidden) => [
      ...[activation, `2-${hidden}-1`],
      ...rates.map((rate) => counted(layersOf(hidden, activation), { ...base, rate })),
      counted(layersOf(hidden, activation), { ...base, rate: 0.03, optimizer: 'adam', momentum: 0 }),
    ]),
  )
  return {
    title: 'How many of 50 seeds learn either-or',
    how: 'Eight rows, 400 rounds from zero, batch 4, momentum 0.9; learned: a mean square below 0.1.',
    columns: ['hidden', 'net', ...rates.map((rate) => `rate ${rate}`), 'Adam 0.03'],
    rows: lines,
    notes: ['A number is a count of seeds; the rest got stuck.'],
  }
}
