import type { Example } from '../../testing/contract.ts'
import type { SmallWorld } from '../q-senses.ts'
import type { Settings } from '../types.ts'

const parameters: Settings = { alpha: 0.2, gamma: 0.9, rho: 0.2, fall: 200, alphaDecay: 'visits' }
const data: SmallWorld = {
  to: [[3, 0, 1], [0, 1, 2], [1, 2, 3], [3, 3, 3]], // prettier-ignore
  reward: [[-5, 0, 1], [-0.5, 0, 1], [-0.5, 0, -5], [0, 0, 0]], // prettier-ignore
  ends: [false, false, false, true],
  starts: [0, 1, 2],
}

export const example: Example = { parameters, data, steps: 300 }
