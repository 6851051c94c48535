import type { Brain } from '@botgarten/learning/neural-network'
import { addToHash, startHash, type Hash } from '@botgarten/numbers'
import {
  indexProgram,
  runThread,
  startThread,
  type Program,
  type ProgramIndex,
  type Thread,
} from '@botgarten/programs'
import {
  degreesOf,
  KEYFRAME_EVERY,
  TICKS_PER_SECOND,
  type Pose,
  type Simulation,
  type SimulationState,
} from '@botgarten/simulation'
import type { Context } from '@botgarten/blocks'
import { observe, watch, type Watch } from './checks/checks.ts'
import { withHandOnKeys } from './inputs/keys.ts'
import { RobotBrains, type Brains } from './robots/brains.ts'
import { robotOf } from './robots/robot.ts'
import { Timeline } from './timeline/timeline.ts'
import type { Check, DriveKey, Input, Tone, TrailPoint } from './types.ts'

/** Trail points are this many ticks apart: ten a second. */
const TRAIL_EVERY = 6
const LONGEST_TRAIL = 6000

export interface RobotRun {
  readonly index: ProgramIndex
  readonly brains: RobotBrains
  readonly context: Context & { now: number }
  thread: Thread
  trail: TrailPoint[]
  /** Every tone that began or ended; frequency 0 is silence. */
  tones: Tone[]
}

/** Everything that decides how a run goes on, as plain data. */
export interface Moment {
  readonly tick: number
  readonly simulation: SimulationState
  readonly threads: readonly Thread[]
  readonly brains: Brains
  readonly lastInputs: readonly (readonly (readonly [string, readonly number[]])[])[]
  readonly keys: readonly DriveKey[]
  readonly watches: readonly Watch[]
  readonly hash: Hash
  readonly endedAt: number | null
}

/** One run of a world and its programs from a Start on: ticks, and the way back to any of them. */
export class Run {
  readonly simulation: Simulation
  readonly checks: readonly Check[]
  readonly robots: readonly RobotRun[]
  readonly #timeline = new Timeline<Moment>()
  brains: Brains
  keys: DriveKey[]
  watches: Watch[]
  hash: Hash = startHash()
  tick = 0
  /** Tick at which the last program ended; null while one runs. */
  endedAt: number | null = null
  #replaying = false

  constructor(
    simulation: Simulation,
    programs: { readonly [id: string]: Program },
    brains: Brains,
    checks: readonly Check[],
    keys: readonly DriveKey[],
  ) {
    this.simulation = simulation
    this.brains = brains
    this.checks = checks
    this.keys = [...keys]
    this.watches = watch(checks)
    this.robots = simulation.world.robots.map((placement, robot) => {
      const nets = new RobotBrains(placement, brains)
      const index = indexProgram(programs[placement.program] ?? { stacks: [], config: { stacks: [] } })
      const think = (id: string, inputs: readonly number[]) => nets.think(id, inputs)
      return {
        index,
        brains: nets,
        context: { robot: robotOf(simulation, robot), now: 0, think },
        thread: startThread(index),
        trail: [],
        tones: [],
      }
    })
    this.#timeline.keep(this.moment())
  }

  /** Simulated seconds since Start. */
  get seconds(): number {
    return this.tick / TICKS_PER_SECOND
  }

  /** Takes an input for the coming tick and writes it into the log (running.md 2). */
  give(input: Input): void {
    if (!this.#replaying) this.#timeline.log(this.tick, input)
    if (input.kind === 'place') this.simulation.place(input.id, input.pose)
    else if (input.kind === 'key') this.#press(input.key, input.down)
    else this.#use(input.brain, input.value)
  }

  #press(key: DriveKey, down: boolean): void {
    this.keys = this.keys.filter((pressed) => pressed !== key)
    if (down) this.keys.push(key)
  }

  #use(id: string, brain: Brain): void {
    this.brains = { ...this.brains, [id]: brain }
    for (const robot of this.robots) robot.brains.use(id, brain)
  }

  /** Programs in order of robots, up to the end of their tick. With `untilNextBlock` the first stops after one block. */
  runThreads(untilNextBlock = false): boolean {
    const finished = this.robots.map((robot) => {
      robot.context.now = this.seconds
      return runThread(robot.thread, robot.index, robot.context, untilNextBlock)
    })
    return finished.every(Boolean)
  }

  /** One tick, in the order of running.md 2. */
  advance(): void {
    this.runThreads()
    this.#noteEnd()
    withHandOnKeys(this.simulation, this.keys, () => this.simulation.step())
    this.tick++
    this.#addHash()
    observe(this.checks, this.watches, this.seconds, this.simulation)
    this.#noteTones()
    if (this.tick % TRAIL_EVERY === 0) this.#leaveTrail()
    if (this.tick % KEYFRAME_EVERY === 0 && !this.#replaying) this.#timeline.keep(this.moment())
  }

  /** A tick without programs: a robot that is driven by hand, things that still move. Returns whether there was any. */
  idle(): boolean {
    const moves = this.simulation.state.obstacles.some(
      ({ vx, vy, spin }) => vx !== 0 || vy !== 0 || spin !== 0,
    )
    if (this.keys.length === 0 && !moves) return false
    withHandOnKeys(this.simulation, this.keys, () => this.simulation.step())
    return true
  }

  /** After the last program has ended, time goes on for as long as a check may need to see the robot stand. */
  get isOver(): boolean {
    const linger = Math.max(0, ...this.checks.map(({ seconds }) => seconds)) * TICKS_PER_SECOND
    return this.endedAt !== null && this.tick >= this.endedAt + linger
  }

  /** Where a robot or an obstacle stands now. */
  poseOf(id: string): Pose | null {
    const { world, state } = this.simulation
    const robot = world.robots.findIndex((placement) => placement.id === id)
    const thing = state.robots[robot] ?? state.obstacles.find((obstacle) => obstacle.id === id)
    return thing ? { x: thing.x, y: thing.y, heading: degreesOf(thing.heading) } : null
  }

  #noteEnd(): void {
    if (this.endedAt !== null || !this.robots.every(({ thread }) => thread.ended)) return
    this.endedAt = this.tick
  }

  #addHash(): void {
    for (const { x, y, heading } of this.simulation.state.robots) {
      addToHash(this.hash, x)
      addToHash(this.hash, y)
      addToHash(this.hash, heading)
    }
  }

  #noteTones(): void {
    this.simulation.state.robots.forEach(({ tone }, index) => {
      const { tones } = this.robots[index]!
      const frequency = tone?.frequency ?? 0
      if (frequency !== (tones.at(-1)?.frequency ?? 0)) tones.push({ t: this.seconds, frequency })
      if (tones.length > LONGEST_TRAIL) tones.splice(0, LONGEST_TRAIL / 10)
    })
  }

  #leaveTrail(): void {
    this.simulation.state.robots.forEach(({ x, y, heading }, index) => {
      const { trail } = this.robots[index]!
      trail.push({ t: this.seconds, x, y, heading })
      if (trail.length > LONGEST_TRAIL) trail.splice(0, LONGEST_TRAIL / 10)
    })
  }

  moment(): Moment {
    return {
      tick: this.tick,
      simulation: this.simulation.keyframe(),
      threads: this.robots.map(({ thread }) => structuredClone(thread)),
      brains: this.brains,
      lastInputs: this.robots.map(({ brains }) => [...brains.lastInputs]),
      keys: [...this.keys],
      watches: structuredClone(this.watches),
      hash: [...this.hash],
      endedAt: this.endedAt,
    }
  }

  /** Back or forth to a tick of this run: nearest keyframe, then replay with the log (running.md 8). */
  goTo(tick: number): void {
    const from = this.#timeline.before(tick)
    if (!from) return
    if (from.tick > this.tick || tick < this.tick) this.#restore(from)
    this.#replaying = true
    while (this.tick < tick) {
      for (const input of this.#timeline.inputsAt(this.tick)) this.give(input)
      this.advance()
    }
    this.#replaying = false
  }

  #restore(moment: Moment): void {
    this.simulation.restore(moment.simulation)
    this.tick = moment.tick
    for (const [id, brain] of Object.entries(moment.brains)) this.#use(id, brain)
    this.brains = moment.brains
    this.keys = [...moment.keys]
    this.watches = structuredClone(moment.watches) as Watch[]
    this.hash = [...moment.hash]
    this.endedAt = moment.endedAt
    this.robots.forEach((robot, index) => {
      robot.thread = structuredClone(moment.threads[index]!)
      robot.brains.lastInputs.clear()
      for (const [id, inputs] of moment.lastInputs[index]!) robot.brains.lastInputs.set(id, inputs)
      robot.trail = robot.trail.filter(({ t }) => t <= this.seconds)
      robot.tones = robot.tones.filter(({ t }) => t <= this.seconds)
    })
  }
}
