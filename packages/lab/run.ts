import { emptyBrain, withWeight, type Brain } from '@botgarten/learning/neural-network/brain'
import { addToHash, startHash, type Hash } from '@botgarten/numbers'
import { learningIn, runThread, type LearningOutline, type Raced } from '@botgarten/programs'
import { pressKey, rollsOn, TICKS_PER_SECOND, type Pose, type Simulation } from '@botgarten/simulation'
import { goOnFrom } from './carry.ts'
import { observe, watch, type Watch } from './checks/checks.ts'
import { seenIn, type Seen } from './checks/seen.ts'
import { withHands } from './inputs/hands.ts'
import type { DriveKey, Input } from './inputs/input.ts'
import { repeats } from './inputs/repeats.ts'
import { School } from './recording/school.ts'
import { teachingOf } from './recording/teaching.ts'
import type { Brains } from './robots/brains.ts'
import { mailOf } from './robots/mail.ts'
import { robotRun, type RobotRun } from './robots/run.ts'
import { momentOf, poseIn, restore, type Course, type Moment } from './timeline/moment.ts'
import { shared } from './timeline/shared.ts'
import { Timeline } from './timeline/timeline.ts'
import { newTrack, note, touchesIn, trackUntil, type Track } from './timeline/tracks.ts'
import { Trials } from './trying/trials.ts'
import type { Check, Document, TimeView } from './types.ts'

/** Ticks from keyframe to keyframe: so few that any moment is there again at once, on a slow laptop too. */
const KEYFRAME_EVERY = 60

/** One run of a world and its programs from a Start on: ticks, and the way back to any of them. */
export class Run {
  readonly simulation: Simulation
  readonly checks: readonly Check[]
  readonly robots: readonly RobotRun[]
  tracks: readonly Track[]
  brains: Brains
  starts: Moment['starts']
  keys: readonly DriveKey[] = []
  readonly school = new School(this)
  readonly trials: Trials
  /** What came of its project's last race of brains. */
  readonly raced: Raced | null
  /** Roads that the first robot's program closes on its map. */
  readonly closed: LearningOutline['closed']
  watches: Watch[]
  hash: Hash = startHash()
  tick = 0
  /** Tick at which the last program ended; null while one runs. */
  endedAt: number | null = null
  /** Index of the robot that the keys drive. */
  driven = 0
  /** How far this tick has come: steps of its programs from block to block, and inputs that were given. */
  part = 0
  given = 0
  /** What checks see of the moment that is shown. */
  readonly seen: Seen
  #timeline = new Timeline<Moment>()
  /** The present, while a moment of the past is shown. */
  #now: Moment | null = null

  /** `before`: a run that this one goes on from, where the document was changed under it. */
  constructor(
    simulation: Simulation,
    { programs, brains, tables = {}, raced, world }: Document,
    checks: readonly Check[],
    before: Run | null = null,
  ) {
    this.simulation = simulation
    this.brains = brains
    this.trials = new Trials(simulation, tables)
    this.raced = raced ?? null
    const program = programs[world.robots[0]!.program]
    this.closed = (program && learningIn(program)?.closed) ?? []
    this.starts = Object.fromEntries(world.obstacles.map(({ id, pose }) => [id, pose]))
    this.checks = checks
    this.watches = watch(checks)
    this.robots = simulation.world.robots.map((_, index) =>
      robotRun(
        simulation,
        index,
        programs,
        brains,
        mailOf(index, () => this.robots),
        (program) => ({
          teaching: teachingOf(this, index, program),
          trying: this.trials.tryingOf(index, program),
        }),
      ),
    )
    this.tracks = this.robots.map(newTrack)
    this.seen = seenIn(this)
    if (before) goOnFrom(before, this)
    this.#timeline.keep(momentOf(this))
  }

  /** Simulated seconds since Start. */
  get seconds(): number {
    return this.tick / TICKS_PER_SECOND
  }

  /** Index of a robot; the first where none is named. */
  robotAt(id: string | undefined): number {
    return Math.max(
      0,
      this.robots.findIndex((robot) => robot.id === id),
    )
  }

  get inPast(): boolean {
    return this.#now !== null
  }

  /**
   * Practises what programs asked for in the tick before, about so many examples of it; no time passes until it is done. Returns
   * whether it is.
   */
  practise(examples = Infinity): boolean {
    return this.school.practise(examples)
  }

  /** Takes an input for the coming tick; in a run it is written into the log (running.md 2). Not in the past. */
  give(input: Input, inRun: boolean): void {
    // Practice comes before what a hand does to the same brain.
    if ('brain' in input || input.kind === 'remember') this.practise()
    const before = input.kind === 'place' ? this.poseOf(input.id) : null
    this.#take(input)
    if (!inRun) return
    const last = this.#timeline.inputsAt(this.tick).at(-1)
    const again = last?.part === this.part && repeats(last.input, input)
    // A thing that is dragged while time stands still is only where it was put last.
    if (again && input.kind === 'place' && samePose(before, this.poseOf(input.id))) return
    this.#timeline.log(this.tick, { part: this.part, input }, again)
    this.given = this.#timeline.inputsAt(this.tick).length
  }

  #take(input: Input): void {
    if (input.kind === 'place') this.#place(input.id, input.pose)
    else if (input.kind === 'key') this.#press(input.key, input.down, input.robot)
    else if (input.kind === 'button') pressKey(this.simulation, input.robot, input.key, input.down)
    else if (input.kind === 'brain') this.use(input.brain, input.value)
    else if (input.kind !== 'weight') this.school.take(input)
    else {
      const { brain, from, to, weight, set } = input
      this.use(brain, withWeight(this.brains[brain] ?? emptyBrain, from, to, weight, set))
    }
  }

  #place(id: string, pose: Pose): void {
    const came = this.simulation.place(id, pose)
    const isThing = this.simulation.world.obstacles.some((obstacle) => obstacle.id === id)
    if (isThing) this.starts = { ...this.starts, [id]: came }
  }

  #press(key: DriveKey, down: boolean, robot: number): void {
    this.driven = robot
    this.keys = [...this.keys.filter((pressed) => pressed !== key), ...(down ? [key] : [])]
  }

  use(id: string, brain: Brain): void {
    this.brains = { ...this.brains, [id]: brain }
    for (const robot of this.robots) robot.brains.use(id, brain)
  }

  show(id: string, brain: Brain): void {
    this.brains = { ...this.brains, [id]: brain }
    for (const robot of this.robots) robot.brains.shown(id, brain)
  }

  /** Programs in order of robots, up to the end of their tick. With `untilNextBlock` each stops after one block. */
  #runThreads(untilNextBlock = false): boolean {
    if (untilNextBlock) this.part++
    const over = this.robots.map((robot) => {
      robot.context.now = this.seconds
      return runThread(robot.thread, robot.index, robot.context, untilNextBlock)
    })
    return over.every(Boolean)
  }

  /** One step of the programs from block to block, inside this tick. Returns whether the tick is over for all. */
  stepBlocks(): boolean {
    this.practise()
    if (this.#now) this.#giveAgain(this.part)
    return this.#runThreads(true)
  }

  /** What was given in this tick of the past, up to a part of it. */
  #giveAgain(part: number): void {
    this.practise()
    const inputs = this.#timeline.inputsAt(this.tick)
    for (let next = inputs[this.given]; next && next.part <= part; next = inputs[this.given]) {
      while (this.part < next.part) this.#runThreads(true)
      this.#take(next.input)
      this.given++
    }
  }

  /** One tick, in the order of running.md 2. In the past it is the one that was, up to the present. */
  advance(): void {
    this.practise()
    if (this.#now) this.#giveAgain(Infinity)
    this.#runThreads()
    this.#noteEnd()
    this.school.takeHands()
    const touched = touchesIn(this.simulation.state)
    withHands(this.simulation, this.school.hands, () => this.simulation.step())
    this.tick++
    this.part = this.given = 0
    this.#addHash()
    observe(this.checks, this.watches, this.seconds, this.seen)
    if (!this.#now) this.#keep(touched)
    else if (this.tick >= this.#now.tick) this.toNow()
  }

  #keep(touched: readonly boolean[]): void {
    note(this.tracks, this.tick, this.simulation.state, touched)
    if (this.tick % KEYFRAME_EVERY === 0)
      this.#timeline.keep(shared(momentOf(this), this.#timeline.last ?? null))
  }

  /** A tick without programs: a robot that is driven by hand, things that still move. Returns whether there was any. */
  idle(): boolean {
    const moves = this.simulation.state.obstacles.some(
      ({ vx, vy, spin }) => vx !== 0 || vy !== 0 || spin !== 0,
    )
    const driven = this.school.state.hand !== null || this.keys.length > 0
    if (!driven && !moves && !this.simulation.state.robots.some(rollsOn)) return false
    this.school.showHeld()
    withHands(this.simulation, this.school.hands, () => this.simulation.step())
    return true
  }

  /** After the last program has ended, time goes on for as long as a check may need to see the robot stand. */
  get isOver(): boolean {
    const linger = Math.max(0, ...this.checks.map(({ seconds }) => seconds)) * TICKS_PER_SECOND
    return this.endedAt !== null && this.tick >= this.endedAt + linger
  }

  /** Where a robot or an obstacle stands at the moment that is shown. */
  poseOf(id: string): Pose | null {
    const { world, state } = this.simulation
    const robot = world.robots.findIndex((placement) => placement.id === id)
    return poseIn(state.robots[robot] ?? state.obstacles.find((obstacle) => obstacle.id === id))
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

  /** Back or forth to a tick of this run: nearest keyframe, then replay with the log (running.md 8). */
  goTo(tick: number): void {
    const now = this.#now?.tick ?? this.tick
    if (tick >= now) return this.toNow()
    const wanted = Math.max(tick, this.#timeline.first)
    const from = this.#timeline.before(wanted)
    if (!from || wanted === this.tick) return
    this.#now ??= momentOf(this)
    if (from.tick > this.tick || wanted < this.tick) restore(this, from)
    while (this.tick < wanted) this.advance()
  }

  toNow(): void {
    if (this.#now) restore(this, this.#now)
    this.#now = null
  }

  /** Makes the moment of the past that is shown the present. Returns the course of time that is left. */
  branch(): Course | null {
    if (!this.#now) return null
    const left = { timeline: this.#timeline, tracks: this.tracks, now: this.#now }
    this.#timeline = this.#timeline.until(this.tick, this.given)
    this.tracks = this.tracks.map((track) => trackUntil(track, this.seconds))
    this.#now = null
    return left
  }

  /** Goes over to the end of another course of time. Returns the one that is left. */
  take({ timeline, tracks, now }: Course): Course {
    this.toNow()
    const left = { timeline: this.#timeline, tracks: this.tracks, now: momentOf(this) }
    this.#timeline = timeline
    this.tracks = tracks
    restore(this, now)
    return left
  }

  time(): Omit<TimeView, 'other'> {
    const now = this.#now
    return {
      first: this.#timeline.first,
      now: now?.tick ?? this.tick,
      past: now !== null,
      marks: this.#timeline.marks,
      present: now
        ? this.robots.map(({ id }, index) => ({ id, pose: poseIn(now.simulation.robots[index])! }))
        : [],
    }
  }
}

const samePose = (a: Pose | null, b: Pose | null) =>
  a?.x === b?.x && a?.y === b?.y && a?.heading === b?.heading
