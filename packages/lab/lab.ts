import { hex } from '@botgarten/numbers'
import { createSimulation, freshRobot, type Floor, type Pose, type Simulation } from '@botgarten/simulation'
import { missing } from './checks/checks.ts'
import { carryOver } from './carry.ts'
import { emptyWorld, sameBlocks, withBrains, withPoses } from './documents.ts'
import { HandsOnLab } from './inputs/hands-on-lab.ts'
import type { Input } from './inputs/input.ts'
import { sensesOf } from './robots/senses.ts'
import { Run } from './run.ts'
import { reachStop, stepBlock, stepNetwork, type Stops, type Walk } from './stepping.ts'
import { momentOf, type Course } from './timeline/moment.ts'
import { tryViewOf } from './trying/shown.ts'
import type { Check, Document, Lab, Phase, StepKind } from './types.ts'
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
  #other: Other | null = null
  #stops: Stops = new Set()
  readonly #hands = new HandsOnLab({
    run: () => this.#run,
    isOn: () => this.#isOn,
    branch: () => this.branch(),
    give: (input) => this.#give(input),
  })
  readonly setWeight = this.#hands.setWeight
  readonly setBrain = this.#hands.setBrain
  readonly setTraining = this.#hands.setTraining
  readonly remember = this.#hands.remember
  readonly drive = this.#hands.drive
  readonly record = this.#hands.record
  readonly press = this.#hands.press
  readonly pressButton = this.#hands.pressButton

  load(document: Document, floor: Floor, options: Options): void {
    this.#document = withBrains(document)
    this.#floor = floor
    this.#options = options
    this.reset()
  }

  reset(): void {
    this.#phase = 'ready'
    this.#hands.drove = false
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
    this.#hands.takeHold()
  }

  edit(programs: Document['programs'], fromStart = false): void {
    const moved = sameBlocks(programs, this.#document.programs)
    if (!moved) this.#run.toNow()
    const before = this.#document.programs
    this.#document = withBrains({ ...this.#document, programs })
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
    this.#document = withBrains(document)
    this.#floor = floor
    const before = this.#simulation
    this.#simulation = this.#atStart()
    const came = carryOver(before, this.#simulation, stood)
    this.#document = { ...this.#document, world: withPoses(this.#document.world, came, true) }
    this.#begin(this.#run)
  }

  start(): void {
    this.#run.toNow()
    // Goals count from a start pose, so where there are goals every run begins there, as after a run that ended.
    const fromStart = this.#phase === 'ended' || this.#options.checks.length > 0
    if (fromStart && !this.#hands.drove) this.#simulation = this.#atStart()
    for (const robot of this.#simulation.state.robots) freshRobot(robot)
    this.#phase = 'running'
    this.#begin()
    this.#hands.drove = false
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
    const index = this.#run.robotAt(robot)
    if (kind === 'tick') this.#tick()
    else if (kind === 'network') stepNetwork(this.#walk(), index)
    else stepBlock(this.#walk(), index, kind === 'over', this.#stops)
  }

  setStops(blocks: readonly string[]): void {
    this.#stops = new Set(blocks)
  }

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
      if (!this.#run.inPast) this.#hands.takeHold()
      return
    }
    if (this.#run.brains !== this.#document.brains) this.#takeBrains()
    if (this.#run.trials.tables !== this.#document.tables) this.#takeTables()
    if (!this.#run.isOver) return
    this.stop()
    this.#phase = 'ended'
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

  variables = (robot?: string) => {
    const run = this.#run.robots[this.#run.robotAt(robot)]
    return run ? variablesOf(run) : []
  }

  trying = (robot?: string) => tryViewOf(this.#run, this.#run.robotAt(robot), !this.#isOn)

  senses = (robot?: string) => sensesOf(this.#simulation, this.#run.robotAt(robot))

  #give(input: Input): void {
    this.#run.give(input, this.#isOn)
    this.#takeBrains()
  }

  /** What the run has made of its brains is the document's too: weights, rows that were written. */
  #takeBrains(): void {
    if (!this.#run.inPast) this.#document = { ...this.#document, brains: this.#run.brains }
  }

  /** So are tables that were learned in it. */
  #takeTables(): void {
    const { tables } = this.#run.trials
    if (Object.keys(tables).length > 0) this.#document = { ...this.#document, tables }
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
    this.#hands.takeHold()
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
    this.#hands.takeHold()
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
    this.#hands.takeHold()
    return true
  }

  state = () => momentOf(this.#run)
  view = (robot?: string) =>
    viewOf(this.#run, this.now().phase, this.#run.robotAt(robot), this.#other !== null)
  now = () => ({
    tick: this.#run.tick,
    phase: this.#run.inPast ? ('paused' as const) : this.#phase,
    practising: this.#run.school.state.wanted.length > 0,
  })
  missing = () => missing(this.#run.checks, this.#run.watches, this.#run.seconds, this.#run.seen)
  document = () => this.#document
  floor = () => this.#floor
  hash = () => hex(this.#run.hash)
}
