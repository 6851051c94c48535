import { executeOrders, hertzPerLevel, type Order, type Value } from '@botgarten/blocks'
import { evaluate, networksByUse, type NetworkOutline, type NeuronOutline } from '@botgarten/programs'
import type { RobotConfig, RobotState } from '@botgarten/simulation'
import type { RobotRun } from '../robots/run.ts'
import type { Wheels } from '../inputs/input.ts'

/** What a row has of a network: percent by the ids of its neurons. */
export interface Columns {
  readonly [neuronId: string]: number
}

export const networkOf = ({ program }: RobotRun, id: string): NetworkOutline | undefined =>
  networksByUse(program).find((network) => network.id === id)

/** What a network reads in this tick (running.md 14): what its block has read, where it has run; else what it would read. */
export function readInputs(robot: RobotRun, network: NetworkOutline): Columns {
  const last = robot.brains.lastRuns.get(network.id)
  if (last?.now !== robot.context.now) return inputsNow(robot, network)
  return columns(network.inputs, (_, k) => finite(last.inputs[k]))
}

/** What it would read now. A neuron that cannot read counts 0. */
export const inputsNow = ({ index, context }: RobotRun, { inputs }: NetworkOutline): Columns =>
  columns(inputs, ({ id }) => finite(evaluate(index, id, context)))

function finite(value: unknown): number {
  const number = Number(value ?? 0)
  return Number.isFinite(number) ? number : 0
}

const columns = (neurons: readonly NeuronOutline[], value: (neuron: NeuronOutline, k: number) => number) =>
  Object.fromEntries(neurons.map((neuron, k) => [neuron.id, value(neuron, k)]))

const isOrder = (value: Value): value is Order =>
  typeof value === 'object' && value !== null && 'order' in value

/** What an output neuron wants done at a level. */
function orderOf({ index, context }: RobotRun, { id }: NeuronOutline, level: number): Order | null {
  const value = evaluate(index, id, context, [level])
  return isOrder(value) ? value : null
}

/** What a hand holds for each output: the wheels, and by its neuron what else was chosen. Lamps and words: 100 or −100. */
export function heldOutputs(
  robot: RobotRun,
  { outputs }: NetworkOutline,
  { left, right }: RobotConfig['drive'],
  wheels: Wheels,
  others: Columns,
): Columns {
  return columns(outputs, (neuron) => {
    const order = orderOf(robot, neuron, 0)
    if (order?.order === 'motor' && order.port === left) return wheels.left
    if (order?.order === 'motor' && order.port === right) return wheels.right
    return others[neuron.id] ?? (order?.order === 'led' || order?.order === 'text' ? -100 : 0)
  })
}

/** What a robot's program does for each output: how its motors are set, what it shows and sounds. */
export const doneOutputs = (robot: RobotRun, { outputs }: NetworkOutline, state: RobotState): Columns =>
  columns(outputs, (neuron) => {
    const order = orderOf(robot, neuron, 0)
    return order ? doneOf(order, state) : 0
  })

function doneOf(order: Order, { motors, led, display, tone }: RobotState): number {
  switch (order.order) {
    case 'motor':
      return motors[order.port].percent
    case 'led':
      return led === order.colour ? 100 : -100
    case 'text':
      return order.text !== '' && display.some((row) => row.trim() === order.text) ? 100 : -100
    case 'sound':
      return Math.min(100, (tone?.frequency ?? 0) / hertzPerLevel)
  }
}

/** Shows and sounds what a hand has chosen for outputs that are no wheels, after the program (running.md 16). */
export function showHeld(robot: RobotRun, { outputs }: NetworkOutline, others: Columns): void {
  const chosen = outputs.filter(({ id }) => Object.hasOwn(others, id))
  if (chosen.length === 0) return
  // Words stand below each other in the order of their neurons: one that is not chosen is off.
  const orders = outputs.map((neuron) => orderOf(robot, neuron, others[neuron.id] ?? -100))
  const isHeld = (order: Order | null, k: number) =>
    order?.order !== 'motor' || Object.hasOwn(others, outputs[k]!.id)
  executeOrders(orders.filter(isHeld), robot.context.robot)
}
