import type { Activation } from '@botgarten/learning/neural-network'
import { withActivation } from '@botgarten/learning/neural-network/brain'
import { m } from '#words/message.ts'
import type { Practice } from '../model/practice.svelte.ts'
import type { Training } from '../training.svelte.ts'

export interface Said {
  readonly text: string
  /** One press that changes it. */
  readonly way?: { readonly label: string; readonly act: () => void }
}

/** What is to be said about practice as it stands; null: nothing. */
export function stopOf(training: Training): Said | null {
  const { practice } = training
  return obstacleOf(training) ?? endingOf(practice) ?? noteOf(practice)
}

function obstacleOf(training: Training): Said | null {
  const { practice } = training
  const { obstacle, net } = practice
  if (!obstacle || !net) return null
  switch (obstacle.kind) {
    case 'noRows':
      return { text: practice.examples?.rows.length ? m['training.allAside']() : m['training.noRows']() }
    case 'threshold':
      return {
        text: m['training.threshold'](),
        ...wayOut(practice, obstacle.neurons, 'tanh', m['training.takeTanh']()),
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
      return { text: m['training.softmax'](), ...wayOut(practice, ids, 'identity', m['training.takeSum']()) }
    }
    default:
      return { text: m[`training.${obstacle.kind}`]() }
  }
}

/** One press gives outputs another activation; what a hidden layer has is in its block. */
function wayOut(
  practice: Practice,
  neurons: readonly string[],
  to: Activation,
  label: string,
): Pick<Said, 'way'> {
  const { net, session } = practice
  const areOutputs = neurons.every((id) => net!.outputs.some((one) => one.id === id))
  if (!areOutputs) return {}
  const act = () =>
    session.weights.change(net!.id, (brain) =>
      neurons.reduce((changed, neuron) => withActivation(changed, neuron, to), brain),
    )
  return { way: { label, act } }
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

function noteOf(practice: Practice): Said | null {
  if (practice.outcome.shaken) return { text: m['training.shaken']() }
  if (practice.prepared?.asks) return { text: m['training.whichTest']() }
  if (practice.prepared && practice.prepared.gaps > 0)
    return { text: m['training.gaps']({ count: practice.prepared.gaps }) }
  return null
}
