import type { Mirror } from '@botgarten/learning/neural-network/train'
import type { MotorPort, RobotConfig, SensorPort } from '@botgarten/simulation'
import type { NetworkOutline, NeuronOutline } from '../types.ts'

/** The port a neuron names: `ULTRASONIC_PORT_2` is 2, `MOTORPORT_C` is C. '' where it names none. */
const portOf = ({ fields, look }: NeuronOutline): string =>
  look.port === undefined ? '' : (fields[look.port] ?? '').slice(-1)

/** The outputs that drive the wheels, by their place among the outputs; null where one is missing. */
export function wheelsIn({ outputs }: NetworkOutline, { drive }: RobotConfig) {
  const at = (port: MotorPort) => outputs.findIndex((neuron) => portOf(neuron) === port)
  const [left, right] = [at(drive.left), at(drive.right)]
  return left < 0 || right < 0 ? null : { left, right }
}

/**
 * Which neuron stands in for which where left and right change places: sensors that are alike on both sides, and the two wheels.
 * Null where one has no partner, or where no neuron has a side.
 */
export function mirrorIn(network: NetworkOutline, config: RobotConfig): Mirror | null {
  const inputs = network.inputs.map((neuron) =>
    partnerOf(neuron, network.inputs, mirroredSensor(portOf(neuron), config)),
  )
  const outputs = network.outputs.map((neuron) =>
    partnerOf(neuron, network.outputs, mirroredMotor(portOf(neuron), config)),
  )
  const mirror = { inputs, outputs }
  return isMirror(inputs) && isMirror(outputs) && [...inputs, ...outputs].some(isMoved(mirror))
    ? mirror
    : null
}

const isMoved =
  ({ inputs }: Mirror) =>
  (to: number, place: number) =>
    to !== (place < inputs.length ? place : place - inputs.length)

/** Everyone has a partner, whose partner it is. */
const isMirror = (partners: readonly number[]) => partners.every((to, at) => partners[to] === at)

/** The neuron that does the same at the other port; −1 where there is none. */
function partnerOf(neuron: NeuronOutline, all: readonly NeuronOutline[], port: string | null): number {
  const { type, fields, look } = neuron
  return all.findIndex(
    (other) =>
      other.type === type &&
      portOf(other) === port &&
      Object.entries(fields).every(([name, value]) => name === look.port || other.fields[name] === value),
  )
}

/** The port of the like sensor on the other side; its own in the middle; null where there is none. */
function mirroredSensor(port: string, { sensors }: RobotConfig): string | null {
  if (port === '') return ''
  const own = sensors[port as SensorPort]
  if (!own) return null
  const found = Object.entries(sensors).find(
    ([, { kind, x, y, angle }]) =>
      kind === own.kind && x === own.x && y === 0 - own.y && angle === 0 - own.angle,
  )
  return found?.[0] ?? null
}

function mirroredMotor(port: string, { drive }: RobotConfig): string {
  if (port === drive.left) return drive.right
  return port === drive.right ? drive.left : port
}

/** How outputs are right or wrong: `one` of several lamps, `each` word by itself; null: by how far they are off. */
export function choiceIn({ outputs }: NetworkOutline): 'one' | 'each' | null {
  const all = (type: string) => outputs.length > 0 && outputs.every((neuron) => neuron.type === type)
  if (all('ai_nn_output_node_led')) return 'one'
  return all('ai_nn_output_node_text') ? 'each' : null
}
