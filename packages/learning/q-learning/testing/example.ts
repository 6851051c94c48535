import type { Example } from '../../testing/contract.ts'
import { gridMap } from '../grid.ts'
import type { Settings } from '../types.ts'
import { layOutWorld } from '../world.ts'

const parameters: Settings = {
  ...{ rules: 'standard', algorithm: 'sarsa', alpha: 0.5, gamma: 0.8, nu: 0.1, rho: 0.5 },
  ...{ alphaDecay: { kind: 'visits' }, rhoDecay: { kind: 'episodes', factor: 0.9 } },
}

export const example: Example = {
  parameters,
  data: layOutWorld(gridMap(['SFF', 'FWF', 'FFG'])),
  steps: 300,
}
