import type { NetworkInUse } from '@botgarten/programs'
import type { RobotConfig } from '@botgarten/simulation'
import { placeOf } from './words.ts'

/** Does a network that runs set the left and the right wheel? Otherwise no knob makes one wheel faster than the other. */
export function setsBothWheels(nets: readonly NetworkInUse[], config: RobotConfig): boolean {
  const places = (net: NetworkInUse) => new Set(net.outputs.map((neuron) => placeOf(neuron, config)))
  const both = ['network.place.left', 'network.place.right']
  return nets.some((net) => net.idle === null && both.every((place) => places(net).has(place)))
}
