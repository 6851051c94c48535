import { aboveOf, fasterOf, signOf, type Decision } from '@botgarten/learning/neural-network/explain'
import type { NetworkOutline } from '@botgarten/programs'
import type { RobotConfig } from '@botgarten/simulation'

/** What a network decides where an output is asked for, in words of its kind: `turn` between both wheels, `wheel` of one, `on` of a lamp. */
export interface Asked {
  readonly kind: 'turn' | 'wheel' | 'on'
  readonly decision: Decision
}

type Outputs = NetworkOutline['outputs']

/** Port of the motor that an output drives; '' where it drives none. */
const motorOf = ({ look, fields }: Outputs[number]): string =>
  look.port && look.colour === 'actuator' ? (fields[look.port]?.at(-1) ?? '') : ''

/** Indices of the outputs that drive the left and the right wheel; −1 where none does. Of two the last wins. */
export const wheelsOf = (outputs: Outputs, { drive }: RobotConfig) => ({
  left: outputs.findLastIndex((output) => motorOf(output) === drive.left),
  right: outputs.findLastIndex((output) => motorOf(output) === drive.right),
})

/** The decision an output takes part in; null for a neuron that is none. */
export function askedOf(outputs: Outputs, id: string, config: RobotConfig): Asked | null {
  const index = outputs.findIndex((output) => output.id === id)
  const output = outputs[index]
  if (!output) return null
  const { left, right } = wheelsOf(outputs, config)
  if (left >= 0 && right >= 0 && (index === left || index === right))
    return { kind: 'turn', decision: fasterOf(left, right) }
  return motorOf(output) === ''
    ? { kind: 'on', decision: aboveOf(index) }
    : { kind: 'wheel', decision: signOf(index) }
}
