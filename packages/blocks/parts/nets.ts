import { forward, layOut, type Brain } from '@botgarten/learning/neural-network/brain'
import type { Context, HostBrain } from '../types.ts'

/** Names come from files: `constructor` is one that nobody has set. */
const own = <Value>(
  record: { readonly [name: string]: Value } | undefined,
  name: string,
): Value | undefined => (record && Object.hasOwn(record, name) ? record[name] : undefined)

const brainOf = (context: Context): HostBrain | undefined => context.brain?.(context.memory.networkId)

/** Neurons' biases and links' weights as the program has changed them. */
function changed(context: Context, brain: HostBrain): Brain {
  const net = context.memory.net()
  const layers = brain.layers.map((neurons) =>
    neurons.map(({ id, bias }) => ({
      id,
      activation: 'identity' as const,
      bias: own(net.biases, id) ?? bias,
    })),
  )
  const weights = { ...brain.weights }
  for (const [from, to] of Object.entries(net.weights)) weights[from] = { ...own(weights, from), ...to }
  return { kind: 'network', layers, weights, sets: {} }
}

/** Runs the network on the inputs that were set; false where the program carries none. */
export function runNet(context: Context): boolean {
  const plain = brainOf(context)
  if (!plain) return false
  const net = context.memory.net()
  const inputs = (plain.layers[0] ?? []).map(({ id }) => own(net.inputs, id) ?? 0)
  // The screen follows what the host thinks.
  context.think(context.memory.networkId, inputs)
  const brain = changed(context, plain)
  const outputs = forward(layOut(brain), inputs)
  brain.layers.at(-1)?.forEach(({ id }, k) => (net.outputs[id] = outputs[k] ?? 0))
  return true
}

/** null where the network has no such link. */
export function weightIn(context: Context, from: string, to: string): number | null {
  const brain = brainOf(context)
  const layer = brain?.layers.findIndex((neurons) => neurons.some(({ id }) => id === from)) ?? -1
  if (!brain || layer < 0 || !brain.layers[layer + 1]?.some(({ id }) => id === to)) return null
  return own(own(context.memory.net().weights, from), to) ?? own(own(brain.weights, from), to) ?? 0
}

export function setWeight(context: Context, from: string, to: string, weight: number): void {
  const net = context.memory.net()
  net.weights[from] = { ...own(net.weights, from), [to]: weight }
}

/** null where the network has no such neuron behind its inputs. */
export function biasIn(context: Context, name: string): number | null {
  const neuron = brainOf(context)
    ?.layers.slice(1)
    .flat()
    .find(({ id }) => id === name)
  return neuron ? (own(context.memory.net().biases, name) ?? neuron.bias) : null
}

/** What an output gave in the network's last run; 0 before, and where there is no such output. */
export const outputIn = (context: Context, name: string): number =>
  own(context.memory.net().outputs, name) ?? 0
