import { meanLoss, percentOff } from '../neural-network/train/errors.ts'
import { finishThisRound } from '../neural-network/train/step.ts'
import type { Practice, Rows } from '../neural-network/train/types.ts'
import { measure, practise } from './net-code.ts'
import { mostNumbers, type Proof } from './types.ts'

/** Rounds of the draws that a file holds: the last ones; all but those are practised before its start. */
const roundsOf = ({ practised }: Practice, round: number) =>
  Math.min(round, Math.floor(mostNumbers / practised.count))

/**
 * The error of a network after a round: of what is held back, else of what it practises. Yields after every round: it may take
 * as long as the practice itself.
 * @param practice before its first example, with at least so many rounds to go and no patience: it practises here
 */
export function* netProof(practice: Practice, round: number): Generator<undefined, Proof> {
  const from = round - roundsOf(practice, round)
  for (; practice.round < from; yield) finishThisRound(practice)
  const start = startOf(practice)
  const orders: number[][] = []
  for (; practice.round < round; yield) {
    orders.push([...practice.order])
    finishThisRound(practice)
  }
  const { net, kept, practised } = practice
  const rows = kept.count > 0 ? kept : practised
  const loss = meanLoss(practice, rows)!
  return {
    method: 'net',
    number: net.shares ? loss : percentOff(loss),
    before: from,
    data: { ...settingsOf(practice), ...start, orders, ...examplesOf(practice, rows) },
    ...{ learn: practise, show: measure },
  }
}

function settingsOf({ net, settings, moves, decay }: Practice) {
  const { rate, momentum, optimizer, batch, range } = settings
  const neurons = net.neurons.slice(1).map((layer) => layer.map(({ activation }) => activation))
  return {
    ...{ neurons, inputs: net.neurons[0]!.length, rate, momentum, optimizer, batch, range },
    ...{ moves: [...moves], decay: [...decay] },
  }
}

const startOf = ({ parameters, velocity, squares, beta1, beta2 }: Practice) => ({
  ...{ start: [...parameters], velocity: [...velocity], squares: [...squares], beta1, beta2 },
})

function examplesOf({ net, practised }: Practice, test: Rows) {
  const [inputs, outputs] = [net.neurons[0]!.length, net.neurons.at(-1)!.length]
  return {
    inputsOf: table(practised.inputs, inputs),
    targetsOf: table(practised.targets, outputs),
    testInputs: table(test.inputs, inputs),
    testTargets: table(test.targets, outputs),
  }
}

const table = (values: Float64Array, width: number): number[][] =>
  Array.from({ length: values.length / width }, (_, row) => [
    ...values.subarray(row * width, (row + 1) * width),
  ])
