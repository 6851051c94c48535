import { mostInLayer, mostNeurons } from '@botgarten/blocks'
import { withActivation, type Activation } from '@botgarten/learning/neural-network'
import type { NetworkOutline } from '@botgarten/programs'
import type { Blocks } from '#lab/blocks.ts'
import type { LabSession } from '#lab/session.svelte.ts'

/** How many neurons a network may still get. */
export const roomFor = ({ inputs, hidden, outputs }: NetworkOutline): number =>
  hidden.reduce((left, { neurons }) => left - neurons, mostNeurons - inputs.length - outputs.length)

export const canGrow = (net: NetworkOutline, neurons: number): boolean =>
  neurons < mostInLayer && roomFor(net) > 0

/** What becomes of a neuron's sum: a hidden one's is set at its block, for all of its layer. */
export function setActivation(
  session: LabSession,
  blocks: Blocks | undefined,
  net: NetworkOutline,
  neuron: string,
  activation: Activation,
): void {
  const layer = net.hidden.find(({ id }) => neuron.startsWith(`${id}#`))
  if (!layer) return session.weights.change(net.id, (brain) => withActivation(brain, neuron, activation))
  if (activation === 'softmax') return
  blocks?.setLayerActivation(layer.id, activation)
}
