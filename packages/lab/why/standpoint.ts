import { createSimulation, freshRobot, type Floor } from '@botgarten/simulation'
import { Run } from '../run.ts'
import type { Brains } from '../robots/brains.ts'
import type { Moment } from '../timeline/moment.ts'
import { Timeline } from '../timeline/timeline.ts'
import { newTrack } from '../timeline/tracks.ts'
import type { Document } from '../types.ts'

/** From where a drive is imagined: a lab at one of its moments. */
export interface Standpoint {
  readonly document: Document
  readonly floor: Floor
  /** `Lab.state()`. Nothing of it is changed. */
  readonly moment: Moment
  /** Is the moment one of a run? Else programs begin there, as after Start. */
  readonly going: boolean
}

/** A run of its own that stands at this moment, with other brains where there are some. No hand is on its keys. */
export function runFrom({ document, floor, moment, going }: Standpoint, brains: Brains = {}): Run {
  const now = { ...moment, brains: { ...moment.brains, ...brains }, keys: [] }
  const simulation = createSimulation(document.world, floor, 0)
  simulation.restore(moment.simulation)
  if (!going) for (const robot of simulation.state.robots) freshRobot(robot)
  const run = new Run(simulation, { ...document, brains: now.brains }, [])
  if (going) run.take({ timeline: new Timeline<Moment>(), tracks: run.robots.map(newTrack), now })
  return run
}
