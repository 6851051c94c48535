import { trace, type Brain, type NetTrace } from '@botgarten/learning/neural-network'
import { evaluate } from '@botgarten/programs'
import { degreesOf, type Pose, type SensorPort } from '@botgarten/simulation'
import { results } from './checks/checks.ts'
import { weightsFor } from './robots/brains.ts'
import type { RobotRun } from './robots/run.ts'
import type { Run } from './run.ts'
import type { Phase, RobotView, View } from './types.ts'

type Placed = { readonly x: number; readonly y: number; readonly heading: number }

const poseOf = ({ x, y, heading }: Placed): Pose => ({ x, y, heading: degreesOf(heading) })

/** What the screen shows of a run at this moment. `robot`: index of the one whose networks are shown. */
export function viewOf(run: Run, phase: Phase, robot: number, other: boolean): View {
  return {
    phase,
    tick: run.tick,
    seconds: run.seconds,
    robots: run.robots.map((one, index) => robotView(run, one, index, phase)),
    obstacles: run.simulation.state.obstacles.map((obstacle) => ({
      id: obstacle.id,
      pose: poseOf(obstacle),
    })),
    time: { ...run.time(), other },
    brains: run.brains,
    networks: networksOf(run, phase, robot),
    checks: results(run.checks, run.watches),
    problem: run.robots.find(({ thread }) => thread.problem)?.thread.problem ?? null,
  }
}

function robotView(run: Run, robot: RobotRun, index: number, phase: Phase): RobotView {
  const state = run.simulation.state.robots[index]!
  const placement = run.simulation.world.robots[index]!
  const ports = Object.keys(placement.config.sensors) as SensorPort[]
  return {
    id: placement.id,
    pose: poseOf(state),
    motors: Object.fromEntries(Object.entries(state.motors).map(([port, { percent }]) => [port, percent])),
    led: state.led,
    display: state.display,
    frequency: state.tone?.frequency ?? null,
    touching: state.touching,
    rays: Object.fromEntries(ports.map((port) => [port, run.simulation.rays(index, port)])),
    trail: run.tracks[index]!.trail,
    tones: run.tracks[index]!.tones,
    lit: phase === 'running' || phase === 'paused' ? robot.thread.lit : null,
    problem: robot.thread.problem,
  }
}

/** One robot's networks: their last run, or what a run would give now while no program runs. */
function networksOf(run: Run, phase: Phase, index: number): View['networks'] {
  const robot = run.robots[index]
  const placement = run.simulation.world.robots[index]
  const opened: { [id: string]: NetTrace } = {}
  if (!robot || !placement) return opened
  const live = phase === 'ready' || phase === 'ended'
  for (const id of robot.networks) {
    const brain = run.brains[id]
    if (!brain) continue
    const inputs = live ? inputsNow(robot, brain) : (robot.brains.lastInputs.get(id) ?? [])
    opened[id] = trace(brain, inputs, weightsFor(brain, placement))
  }
  return opened
}

/**
 * Reads a network's inputs as its next run would; a neuron that cannot read counts 0.
 * Only while no program runs: a reading may draw noise.
 */
const inputsNow = ({ index, context }: RobotRun, { layers }: Brain): readonly number[] =>
  (layers[0] ?? []).map(({ id }) => Number(evaluate(index, id, context)))
