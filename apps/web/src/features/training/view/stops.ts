import type { Activation } from '@botgarten/learning/neural-network'
import { withActivation } from '@botgarten/learning/neural-network/brain'
import type { Blocks } from '#lab/blocks.ts'
import { columnsFor, withoutGaps } from '@botgarten/learning/neural-network/examples'
import { m } from '#words/message.ts'
import type { Practice } from '../model/practice.svelte.ts'
import type { Training } from '../training.svelte.ts'

export interface Said {
  readonly text: string
  /** One press that changes it. */
  readonly way?: { readonly label: string; readonly act: () => void }
}

/** What is to be said about practice as it stands; null: nothing. */
export function stopOf(training: Training, blocks: Blocks | undefined): Said | null {
  const { practice } = training
  return obstacleOf(training, blocks) ?? endingOf(practice) ?? noteOf(training)
}

function obstacleOf(training: Training, blocks: Blocks | undefined): Said | null {
  const { practice } = training
  const { obstacle, net } = practice
  if (!obstacle || !net) return null
  switch (obstacle.kind) {
    case 'noRows':
      return { text: practice.examples?.rows.length ? m['training.allAside']() : m['training.noRows']() }
    case 'threshold':
      return {
        text: m['training.threshold'](),
        way: { label: m['training.takeTanh'](), act: () => takeTanh(practice, blocks, obstacle.neurons) },
      }
    case 'none':
      return {
        text: m['training.none']({ row: rowOf(practice, obstacle.row) }),
        way: {
          label: m['training.setAside'](),
          act: () => training.setOn([rowOf(practice, obstacle.row) - 1], false),
        },
      }
    case 'softmax': {
      const all = practice.layers.flat().filter(({ activation }) => activation === 'softmax')
      const ids = all.map(({ id }) => id)
      const act = () => setOutputs(practice, ids, 'identity')
      return { text: m['training.softmax'](), way: { label: m['training.takeSum'](), act } }
    }
    default:
      return { text: m[`training.${obstacle.kind}`]() }
  }
}

/** What these outputs do with their sums, as one step. */
function setOutputs({ net, session }: Practice, neurons: readonly string[], to: Activation): void {
  session.weights.change(net!.id, (brain) =>
    neurons.reduce((changed, neuron) => withActivation(changed, neuron, to), brain),
  )
}

/** Neurons that could not practise get a slope: outputs by themselves, hidden ones at the block of their layer. */
function takeTanh(practice: Practice, blocks: Blocks | undefined, neurons: readonly string[]): void {
  const { hidden, outputs } = practice.net!
  for (const { id } of hidden)
    if (neurons.some((neuron) => neuron.startsWith(`${id}#`))) blocks?.setLayerActivation(id, 'tanh')
  const own = neurons.filter((neuron) => outputs.some(({ id }) => id === neuron))
  if (own.length > 0) setOutputs(practice, own, 'tanh')
}

/** Number in the table of a row that practises. */
function rowOf({ prepared }: Practice, at: number): number {
  const { practised, kept } = prepared!
  return ([...practised, ...kept][at]?.row ?? at) + 1
}

function endingOf(practice: Practice): Said | null {
  const { ending, byHeart, sleeping } = practice.outcome
  if (!ending) return null
  if (ending.kind === 'ranAway') return { text: m['training.ranAway']({ round: ending.round }) }
  if (byHeart !== null)
    return {
      text: m['training.byHeart']({ round: byHeart }),
      way: { label: m['training.goBackThere'](), act: () => practice.goTo(byHeart, true) },
    }
  if (sleeping.length > 0) return { text: m['training.sleeps']({ count: sleeping.length }) }
  if (ending.kind === 'noBetter') return { text: m['training.noBetter']({ round: ending.best }) }
  return null
}

/** Rows of before a neuron was added get 0 there. */
function fillGaps({ practice, showing }: Training): void {
  const { inputs, outputs } = practice.net!
  const ids = (layer: typeof inputs) => layer.map(({ id }) => id)
  showing.change((examples) => withoutGaps(columnsFor(examples, ids(inputs), ids(outputs))))
}

function noteOf(training: Training): Said | null {
  const { practice } = training
  if (practice.outcome.shaken) return { text: m['training.shaken']() }
  if (practice.prepared?.asks) return { text: m['training.whichTest']() }
  if (practice.prepared && practice.prepared.gaps > 0)
    return {
      text: m['training.gaps']({ count: practice.prepared.gaps }),
      way: { label: m['training.fillGaps'](), act: () => fillGaps(training) },
    }
  return null
}
