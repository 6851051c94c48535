import { trace, type Brain, type NetTrace, type Weights } from '@botgarten/learning/neural-network/brain'
import { speechLength } from '@botgarten/blocks'
import { evaluate } from '@botgarten/programs'
import {
  degreesOf,
  TICKS_PER_SECOND,
  type Pose,
  type RobotState,
  type SensorPort,
} from '@botgarten/simulation'
import { results } from './checks/checks.ts'
import { isFull } from './recording/recorder.ts'
import { weightsFor } from './robots/brains.ts'
import type { RobotRun } from './robots/run.ts'
import type { Run } from './run.ts'
import type { NetView, Phase, RecordingView, RobotView, View } from './types.ts'

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
    recording: recordingOf(run),
    problem: run.robots.find(({ thread }) => thread.problem)?.thread.problem ?? null,
  }
}

function recordingOf({ school, robots, brains }: Run): RecordingView | null {
  const { recording } = school.state
  if (!recording) return null
  const { robot, network, drive } = recording
  const full = isFull(brains, network, drive.id)
  return { robot: robots[robot]?.id ?? '', network, drive: drive.id, full }
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
    speech: spokenAt(run.simulation.state.tick, state),
    touching: state.touching,
    bumps: run.tracks[index]!.bumps.filter((at) => at <= run.seconds).length,
    trying: run.trials.isTrying(index),
    rays: Object.fromEntries(ports.map((port) => [port, run.simulation.rays(index, port)])),
    trail: run.tracks[index]!.trail,
    tones: run.tracks[index]!.tones,
    lit: phase === 'running' || phase === 'paused' ? robot.thread.lit : null,
    problem: robot.thread.problem,
  }
}

/** What a robot is saying in this tick. */
function spokenAt(tick: number, { speech }: RobotState): string | null {
  if (!speech) return null
  const seconds = speechLength(speech.text, speech.speed) / 1000
  return tick - speech.tick < seconds * TICKS_PER_SECOND ? speech.text : null
}

/** One robot's networks. */
function networksOf(run: Run, phase: Phase, index: number): View['networks'] {
  const robot = run.robots[index]
  const placement = run.simulation.world.robots[index]
  const opened: { [id: string]: NetView } = {}
  if (!robot || !placement) return opened
  for (const id of robot.networks) {
    const brain = run.brains[id]
    const view = brain && networkView(robot, id, brain, phase, (one) => weightsFor(one, placement))
    if (view) opened[id] = view
  }
  return opened
}

function networkView(
  robot: RobotRun,
  id: string,
  brain: Brain,
  phase: Phase,
  weightsOf: (brain: Brain) => Weights,
): NetView | null {
  if (phase === 'ready' || phase === 'ended')
    return { ...trace(brain, inputsNow(robot, brain), weightsOf(brain)), brain, ran: false }
  const last = robot.brains.lastRuns.get(id)
  if (!last) return null
  const then = trace(last.brain, last.inputs, weightsOf(last.brain))
  if (phase === 'running' || last.brain === brain) return { ...then, brain: last.brain, ran: true }
  const now = trace(brain, last.inputs, weightsOf(brain))
  return isSame(now, then) ? { ...then, brain: last.brain, ran: true } : { ...now, brain, ran: false }
}

/** Two runs with the same inputs: did they come about in the same way? */
const isSame = (a: NetTrace, b: NetTrace): boolean =>
  a.terms.length === b.terms.length &&
  a.terms.every(({ from, to, weight }, index) => {
    const other = b.terms[index]!
    return from === other.from && to === other.to && weight === other.weight
  }) &&
  Object.entries(a.biases).every(([id, bias]) => b.biases[id] === bias) &&
  Object.entries(a.outputs).every(([id, value]) => b.outputs[id] === value)

/**
 * Reads a network's inputs as its next run would; a neuron that cannot read counts 0.
 * Only while no program runs: a reading may draw noise.
 */
const inputsNow = ({ index, context }: RobotRun, { layers }: Brain): readonly number[] =>
  (layers[0] ?? []).map(({ id }) => Number(evaluate(index, id, context)))
