import type { Brain } from '@botgarten/learning/neural-network/brain'
import type { Simulation } from '@botgarten/simulation'
import type { Brains } from '../robots/brains.ts'
import { nextTurn } from '../robots/next-turn.ts'
import type { RobotRun } from '../robots/run.ts'
import type { Trials } from '../trying/trials.ts'
import type { Moment } from './moment.ts'

/** What checks see of a run, as it stands whenever they look. */
export type Seen = Pick<Simulation, 'world' | 'state' | 'read'> &
  Pick<Moment, 'taught' | 'nextTurn' | 'trying' | 'table' | 'raced' | 'closed'>

interface Watched {
  readonly simulation: Simulation
  readonly robots: readonly RobotRun[]
  readonly brains: Brains
  readonly seconds: number
  readonly trials: Trials
  readonly raced: Moment['raced']
  readonly closed: Moment['closed']
}

/** Made once for a run: every tick looks through the same one. */
export function seenIn(run: Watched): Seen {
  const { world, state, read } = run.simulation
  const turn: Moment['nextTurn'] = (mirrored, thinks) =>
    nextTurn(run.robots[0]!, world.robots[0]!.config, run.seconds, mirrored, thinks)
  return {
    ...{ world, state, read, nextTurn: turn, raced: run.raced, closed: run.closed },
    get taught() {
      return taughtIn(run)
    },
    get trying() {
      return run.trials.isTrying(0)
    },
    get table() {
      return run.trials.drivesBy(0)
    },
  }
}

/** The first network of the first robot; where its program has none, one that was shown something. */
function taughtIn({ brains, robots }: Watched): Brain | null {
  const own = brains[robots[0]?.networks[0] ?? '']
  return own ?? Object.values(brains).find(({ examples }) => examples) ?? null
}
