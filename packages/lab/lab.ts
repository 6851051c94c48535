import type { Brain } from '@botgarten/learning/neural-network/brain'
import { hex } from '@botgarten/numbers'
import {
  createSimulation,
  freshRobot,
  type Floor,
  type Pose,
  type RobotKey,
  type Simulation,
} from '@botgarten/simulation'
import { missing } from './checks/checks.ts'
import { carryOver } from './carry.ts'
import { emptyWorld, sameBlocks, withPoses } from './documents.ts'
import { brainsFor } from './robots/brains.ts'
import { sensesOf } from './robots/senses.ts'
import { Run } from './run.ts'
import { reachStop, stepBlock, stepNetwork, type Stops, type Walk } from './stepping.ts'
import type { Course } from './timeline/moment.ts'
import type {
  Check,
  Document,
  DriveKey,
  Hand,
  Input,
  Lab,
  Phase,
  Recording,
  StepKind,
  Wheels,
} from './types.ts'
import { variablesOf } from './variables.ts'
import { viewOf } from './view.ts'

/** An empty lab; `load` gives it something to run. */
export const createLab = (): Lab => new OneLab()

interface Options {
  readonly seed: number
  readonly checks: readonly Check[]
}

/** The future that was left when a hand went on from a moment of the past. */
interface Other {
  readonly course: Course
  readonly document: Document
  readonly phase: Phase
}

class OneLab implements Lab {
  #document: Document = { programs: {}, world: emptyWorld, brains: {} }
  #floor: Floor = { width: 1, height: 1, pixelsPerCm: 1, data: new Uint8Array(3) }
  #options: Options = { seed: 0, checks: [] }
  /** Of the present. */
  #phase: Phase = 'ready'
  #simulation!: Simulation
  #run!: Run
  #held: readonly DriveKey[] = []
  /** On the pad, and what is recorded: as it was asked for, whatever moment is shown. */
  #hand: Hand | null = null
  #recording: Recording | null = null
  #buttons: readonly { readonly robot: number; readonly key: RobotKey }[] = []
  #other: Other | null = null
  /** Has a hand driven a robot while no run was on? Then that is where it starts. */
  #handDrove = false
  #stops: Stops = new Set()

  load(document: Document, floor: Floor, options: Options): void {
    this.#document = { ...document, brains: brainsFor(document.programs, document.brains) }
    this.#floor = floor
    this.#options = options
    this.reset()
  }

  reset(): void {
    this.#phase = 'ready'
    this.#handDrove = false
    this.#simulation = this.#atStart()
    this.#begin()
  }

  #atStart = () => createSimulation(this.#document.world, this.#floor, this.#options.seed)

  /** A new run from what stands in the world now: the same start state, seed and inputs give the same run (running.md 2). */
  #begin(before: Run | null = null): void {
    if (!before) {
      const { noise } = this.#atStart().state
      this.#simulation.restore({ ...this.#simulation.keyframe(), tick: 0, noise })
    }
    this.#run = new Run(this.#simulation, this.#document, this.#options.checks, before)
    this.#other = null
    this.#keysAsHeld()
  }

  edit(programs: Document['programs'], fromStart = false): void {
    const moved = sameBlocks(programs, this.#document.programs)
    if (!moved) this.#run.toNow()
    const before = this.#document.programs
    this.#document = { ...this.#document, programs, brains: brainsFor(programs, this.#document.brains) }
    if (moved) return
    if (fromStart && this.#isOn) this.#toStart(before)
    this.#begin()
  }

  /** Whose blocks are others now stands where it started. */
  #toStart(before: Document['programs']): void {
    const { programs, world } = this.#document
    world.robots.forEach(({ id, pose, program }, index) => {
      const [was, now] = [before[program], programs[program]]
      if (was && now && sameBlocks({ main: was }, { main: now })) return
      freshRobot(this.#simulation.state.robots[index]!)
      this.#simulation.place(id, pose)
    })
  }

  rebuild(document: Document, floor: Floor = this.#floor, stood?: { readonly [id: string]: Pose }): void {
    this.#run.toNow()
    this.#document = { ...document, brains: brainsFor(document.programs, document.brains) }
    this.#floor = floor
    const before = this.#simulation
    this.#simulation = this.#atStart()
    const came = carryOver(before, this.#simulation, stood)
    this.#document = { ...this.#document, world: withPoses(this.#document.world, came, true) }
    this.#begin(this.#run)
  }

  start(): void {
    this.#run.toNow()
    if (this.#phase === 'ended' && !this.#handDrove) this.#simulation = this.#atStart()
    for (const robot of this.#simulation.state.robots) freshRobot(robot)
    this.#phase = 'running'
    this.#begin()
    this.#handDrove = false
  }

  stop(): void {
    this.#toNow()
    for (const { context } of this.#run.robots) {
      context.robot.stop()
      context.robot.tone(0, null)
    }
    this.record(null)
    this.#phase = 'ready'
  }

  pause(): void {
    if (this.#phase === 'running') this.#phase = 'paused'
  }

  resume(): void {
    this.branch()
    if (this.#phase === 'paused') this.#phase = 'running'
  }

  step(kind: StepKind, robot?: string): void {
    if (!this.#run.inPast) {
      if (this.#phase === 'ready' || this.#phase === 'ended') this.start()
      this.#phase = 'paused'
    }
    const index = this.#robotAt(robot)
    if (kind === 'tick') this.#tick()
    else if (kind === 'network') stepNetwork(this.#walk(), index)
    else stepBlock(this.#walk(), index, kind === 'over', this.#stops)
  }

  setStops(blocks: readonly string[]): void {
    this.#stops = new Set(blocks)
  }

  /** Index of a robot; the first where none is named. */
  #robotAt = (id: string | undefined) =>
    Math.max(
      0,
      this.#run.robots.findIndex((robot) => robot.id === id),
    )

  /** A step does not go past the present, where that was not where it began. */
  #walk(): Walk {
    const { inPast } = this.#run
    return {
      run: this.#run,
      goesOn: () => this.#run.inPast === inPast && (inPast || this.#phase === 'paused'),
      tick: () => this.#tick(),
    }
  }

  advance(ticks: number, examples = Infinity): boolean {
    if (this.#run.inPast) return false
    if (this.#phase === 'running' && !this.#practise(examples)) return true
    let moved = false
    for (let tick = 0; tick < ticks; tick++) {
      if (this.#phase === 'running') {
        moved = true
        if (this.#stops.size > 0 && reachStop(this.#run, this.#stops)) this.#phase = 'paused'
        else this.#tick()
        if (!this.#practise(examples)) break
      } else if (this.#phase !== 'paused') moved = this.#run.idle() || moved
    }
    return moved
  }

  /** Returns whether all is practised that programs asked for. */
  #practise(examples: number): boolean {
    const { brains } = this.#run
    const isDone = this.#run.practise(examples)
    if (this.#run.brains !== brains) this.#takeBrains()
    return isDone
  }

  #tick(): void {
    const wasPast = this.#run.inPast
    this.#run.advance()
    if (wasPast) {
      if (!this.#run.inPast) this.#keysAsHeld()
      return
    }
    if (this.#run.brains !== this.#document.brains) this.#takeBrains()
    if (!this.#run.isOver) return
    this.stop()
    this.#phase = 'ended'
  }

  setWeight(brain: string, from: string, to: string, weight: number, set = ''): void {
    this.branch()
    this.#give({ kind: 'weight', brain, from, to, weight, set })
  }

  setBrain(brain: string, value: Brain): void {
    this.branch()
    this.#give({ kind: 'brain', brain, value })
  }

  setTraining: Lab['setTraining'] = (brain, change) => {
    this.branch()
    this.#give({ kind: 'training', brain, ...change })
  }

  drive: Lab['drive'] = (wheels, others = {}, robot) => {
    const index = this.#robotAt(robot)
    this.#hand = wheels && { robot: index, ...wholePercent(wheels), others }
    if (this.#run.inPast) return
    this.#handDrove ||= wheels !== null && !this.#isOn
    this.#giveHand(index)
  }

  #giveHand(robot: number): void {
    this.#give({ kind: 'drive', ...(this.#hand ?? { robot, left: null, right: null }) })
  }

  record: Lab['record'] = (recording) => {
    this.#recording = recording && { ...recording, robot: this.#robotAt(recording.robot) }
    if (!this.#run.inPast && this.#recording !== this.#run.school.state.recording) this.#giveRecording()
  }

  #giveRecording(): void {
    this.#give({ kind: 'record', recording: this.#recording })
  }

  remember: Lab['remember'] = (row) => {
    this.branch()
    const before = this.#document.brains[row.network]?.examples?.rows.length ?? 0
    this.#give({ kind: 'remember', ...row, robot: this.#robotAt(row.robot) })
    return (this.#document.brains[row.network]?.examples?.rows.length ?? 0) > before
  }

  place(id: string, pose: Pose, start?: Pose): Pose {
    this.branch()
    this.#give({ kind: 'place', id, pose })
    const came = this.#run.poseOf(id) ?? pose
    const { world } = this.#document
    this.#document = { ...this.#document, world: withPoses(world, { [id]: start ?? came }, !this.#isOn) }
    return came
  }

  /** Robots that are moved while a run is on still start from where they started. */
  get #isOn(): boolean {
    return this.#phase === 'running' || this.#phase === 'paused'
  }

  press(key: DriveKey, down: boolean, robot?: string): void {
    this.#held = [...this.#held.filter((held) => held !== key), ...(down ? [key] : [])]
    // In the past nobody drives; a key that is let go of there is let go of when it is over.
    if (this.#run.inPast) return
    this.#handDrove ||= down && !this.#isOn
    this.#give({ kind: 'key', key, down, robot: this.#robotAt(robot) })
  }

  pressButton(key: RobotKey, down: boolean, robot?: string): void {
    if (down) this.branch()
    const index = this.#robotAt(robot)
    this.#buttons = this.#buttons.filter((held) => held.key !== key || held.robot !== index)
    if (down) this.#buttons = [...this.#buttons, { robot: index, key }]
    if (!this.#run.inPast) this.#give({ kind: 'button', key, down, robot: index })
  }

  /** Keys of a panel that were let go of while the past was shown. */
  #buttonsAsHeld(): void {
    this.#simulation.state.robots.forEach(({ keys }, robot) => {
      for (const key of keys)
        if (!this.#buttons.some((held) => held.key === key && held.robot === robot))
          this.#give({ kind: 'button', key, down: false, robot })
    })
  }

  variables = (robot?: string) => {
    const run = this.#run.robots[this.#robotAt(robot)]
    return run ? variablesOf(run) : []
  }

  senses = (robot?: string) => sensesOf(this.#simulation, this.#robotAt(robot))

  #keysAsHeld(): void {
    this.#buttonsAsHeld()
    if (!sameHand(this.#hand, this.#run.school.state.hand))
      this.#giveHand(this.#run.school.state.hand?.robot ?? 0)
    if (this.#recording !== this.#run.school.state.recording) this.#giveRecording()
    for (const key of new Set([...this.#run.keys, ...this.#held])) {
      const down = this.#held.includes(key)
      if (down !== this.#run.keys.includes(key))
        this.#give({ kind: 'key', key, down, robot: this.#run.driven })
    }
  }

  #give(input: Input): void {
    this.#run.give(input, this.#isOn)
    this.#takeBrains()
  }

  /** What the run has made of its brains is the document's too: weights, rows that were written. */
  #takeBrains(): void {
    if (!this.#run.inPast) this.#document = { ...this.#document, brains: this.#run.brains }
  }

  goTo(tick: number): void {
    if (!(tick < this.#run.time().now)) this.#toNow()
    else {
      this.pause()
      this.#run.goTo(tick)
    }
  }

  #toNow(): void {
    if (!this.#run.inPast) return
    this.#run.toNow()
    this.#keysAsHeld()
  }

  branch(): void {
    const course = this.#run.branch()
    if (!course) return
    const { world, brains } = this.#document
    this.#other = { course, document: this.#document, phase: this.#phase }
    this.#document = {
      ...this.#document,
      brains: { ...brains, ...this.#run.brains },
      world: withPoses(world, this.#run.starts, false),
    }
    this.#phase = 'paused'
    this.#keysAsHeld()
  }

  swap(): boolean {
    if (!this.#other) return false
    this.#toNow()
    this.pause()
    const { course, document, phase } = this.#other
    this.#other = { course: this.#run.take(course), document: this.#document, phase: this.#phase }
    const { programs, world } = this.#document
    this.#document = { ...document, programs, world: { ...document.world, robots: world.robots } }
    this.#phase = phase
    this.#keysAsHeld()
    return true
  }

  state = () => this.#run.moment()
  view = (robot?: string) =>
    viewOf(this.#run, this.#run.inPast ? 'paused' : this.#phase, this.#robotAt(robot), this.#other !== null)
  missing = () => missing(this.#run.checks, this.#run.watches, this.#run.seconds, this.#run.seen)
  document = () => this.#document
  floor = () => this.#floor
  hash = () => hex(this.#run.hash)
}

const wholePercent = ({ left, right }: Wheels): Wheels => ({ left: wholeOf(left), right: wholeOf(right) })

const wholeOf = (percent: number) => Math.max(-100, Math.min(100, Math.round(percent))) + 0

const sameHand = (a: Hand | null, b: Hand | null) =>
  a?.robot === b?.robot && a?.left === b?.left && a?.right === b?.right && a?.others === b?.others
