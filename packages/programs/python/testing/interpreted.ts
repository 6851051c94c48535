import type { Host } from '@botgarten/blocks'
import { forward, layOut, withWeight, type Brain } from '@botgarten/learning/neural-network/brain'
import { brainFor, networks } from '../../networks.ts'
import { indexProgram } from '../../run/index-program.ts'
import { runThread, startThread } from '../../run/thread.ts'
import type { Program, Thread } from '../../types.ts'
import { enough, tracingRobot, type Command } from './tracing-robot.ts'

type Brains = { readonly [id: string]: Brain }

/** For the blocks around `robActions_NNstep`. */
const smallNet: Brain = {
  ...{ kind: 'network', sets: {}, weights: { n1: { n2: 2 } } },
  layers: [[{ id: 'n1', activation: 'identity', bias: 0 }], [{ id: 'n2', activation: 'identity', bias: 1 }]],
}

/** Weights that differ from link to link. */
export function someBrains(program: Program): Brains {
  const brains = networks(program).map((outline) => [outline.id, weighed(brainFor(outline))] as const)
  return { ...Object.fromEntries(brains), [indexProgram(program).networkId]: smallNet }
}

function weighed(brain: Brain): Brain {
  let count = 0
  const links = brain.layers
    .slice(1)
    .flatMap((layer, k) => layer.flatMap(({ id }) => brain.layers[k]!.map((from) => [from.id, id] as const)))
  return links.reduce((now, [from, to]) => withWeight(now, from, to, ((count++ * 7) % 9) / 4 - 1, ''), brain)
}

export interface Interpreted {
  readonly log: readonly Command[]
  /** Why it stopped before its end; null where it did not. */
  readonly problem: string | null
  readonly cut: boolean
  /** How many of its assertions held, and the names of those that did not. */
  readonly held: number
  readonly failed: readonly string[]
}

const ticks = 400

/** What the blocks tell the robot, as `tracesOf` says it of their Python. */
export function interpreted(program: Program, brains: Brains): Interpreted {
  const { robot, log } = tracingRobot()
  const host: Host & { now: number } = {
    ...{ robot, now: 0, brain: (id) => brains[id] },
    think: (id, inputs) => forward(layOut(brains[id]!), inputs),
    mail: { find: () => 'bo2', send: () => {} },
  }
  const index = indexProgram(program)
  const thread = startThread(index)
  try {
    for (let tick = 0; tick < ticks && !thread.ended; tick++) {
      host.now = tick / 60
      runThread(thread, index, host)
    }
  } catch (error) {
    if ((error as Error).message !== enough) throw error
    return { log, problem: null, cut: true, ...asserted(thread) }
  }
  const problem = thread.problem?.problem ?? null
  // The end stops the motors: rule 18.
  const own = thread.ended ? log.slice(0, -2) : log
  return { log: own, problem, cut: !thread.ended, ...asserted(thread) }
}

const asserted = ({ assertions: { passed, failed } }: Thread) => ({
  held: passed,
  failed: failed.map(({ text }) => text),
})
