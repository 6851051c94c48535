import { fastStream } from '@botgarten/numbers'
import { refuseOutside } from '../../parameters.ts'
import { blockFor } from './block.ts'
import { obstacleTo } from './obstacles.ts'
import { layOutTraining, parametersIn } from './layout.ts'
import { beginRound } from './round.ts'
import { parameters as schema } from './settings.ts'
import type { Practice, PracticeData, SavedPractice, Settings, TrainNet } from './types.ts'

/**
 * Practice before its first example.
 * @param stream 4 words of a random stream of its own, for the order of the examples: `stream(seed, 'learn/order/…')`
 * @throws RangeError for a setting outside the schema, for no examples, or where `obstacleTo` finds one
 */
export function beginPractice(settings: Settings, data: PracticeData, stream: readonly number[]): Practice {
  refuseOutside(schema, settings)
  if (data.practised.count < 1) throw new RangeError('There are no examples.')
  const obstacle = obstacleTo(data)
  if (obstacle) throw new RangeError(`It cannot practise: ${obstacle.kind}.`)
  const net = layOutTraining(data.layers)
  const parameters = parametersIn(net, data.weights)
  const practice: Practice = {
    ...{ net, settings, practised: data.practised, kept: data.kept, parameters },
    ...numbersOf(net),
    ...{ moves: movesIn(net, settings), decay: decayIn(net, settings) },
    ...{ whole: parameters.slice(), best: parameters.slice() },
    ...{ block: blockFor(net) },
    order: new Uint32Array(data.practised.count),
    ...{ stream: fastStream(stream), drawn: fastStream(stream) },
    ...{ round: 0, at: 0, inBatch: 0, beta1: 1, beta2: 1, bestRound: 0, bestError: Infinity, ended: null },
  }
  beginRound(practice)
  return practice
}

function numbersOf({ parameters, count }: TrainNet) {
  const [ofParameters, ofNeurons] = [() => new Float64Array(parameters), () => new Float64Array(count)]
  return {
    ...{ gradient: ofParameters(), velocity: ofParameters(), squares: ofParameters() },
    ...{ sums: ofNeurons(), values: ofNeurons(), deltas: ofNeurons() },
  }
}

/** Biases move where they are on; what leads to a threshold has no slope and stays. */
function movesIn({ neurons, layers, parameters }: TrainNet, { bias }: Settings): Float64Array {
  const moves = new Float64Array(parameters).fill(1)
  layers.forEach(({ inputs, outputs, weights, biases }, index) => {
    for (let j = 0; j < outputs; j++) {
      const isFrozen = neurons[index + 1]![j]!.activation === 'threshold'
      if (isFrozen) moves.fill(0, weights + j * inputs, weights + (j + 1) * inputs)
      if (isFrozen || bias === 'off') moves[biases + j] = 0
    }
  })
  return moves
}

function decayIn({ layers, parameters }: TrainNet, { decay }: Settings): Float64Array {
  const all = new Float64Array(parameters)
  for (const { weights, biases } of layers) all.fill(decay, weights, biases)
  return all
}

const arrays = ['parameters', 'gradient', 'velocity', 'squares', 'whole', 'best', 'drawn'] as const

/** Practice as plain data (running.md 2). */
export function savePractice(practice: Practice): SavedPractice {
  const { round, at, inBatch, beta1, beta2, bestRound, bestError, ended } = practice
  const lists = Object.fromEntries(arrays.map((name) => [name, [...practice[name]]]))
  return {
    ...(lists as Record<(typeof arrays)[number], number[]>),
    ...{ round, at, inBatch, beta1, beta2, bestRound, ended },
    bestError: bestError === Infinity ? null : bestError,
  }
}

/** Goes on from a saved state, bit for bit. @throws RangeError where it does not fit this network or these examples */
export function restorePractice(practice: Practice, saved: SavedPractice): void {
  for (const name of arrays)
    if (saved[name].length !== practice[name].length || !saved[name].every(Number.isFinite))
      throw new RangeError(`Of ${name} it needs ${practice[name].length} numbers.`)
  if (!(saved.at >= 0 && saved.at < practice.order.length)) throw new RangeError('It has no such example.')
  for (const name of arrays) practice[name].set(saved[name])
  practice.stream.set(saved.drawn)
  beginRound(practice)
  const { round, at, inBatch, beta1, beta2, bestRound, bestError, ended } = saved
  Object.assign(practice, { round, at, inBatch, beta1, beta2, bestRound, ended })
  practice.bestError = bestError ?? Infinity
}
