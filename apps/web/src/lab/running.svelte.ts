import {
  createLab,
  Pace,
  type Check,
  type Document,
  type DriveKey,
  type Hand,
  type Lab,
  type StepKind,
  type View,
  type Wheels,
} from '@botgarten/lab'
import type { Brain } from '@botgarten/learning/neural-network/brain'
import type { Floor, RobotKey } from '@botgarten/simulation'
import type { EffortCount } from './effort.ts'
import { factsOf, renewed, type Facts } from './facts.ts'

/** Milliseconds of a frame that ticks may take: the rest is for drawing. */
const BUDGET = 10
/** After so many ticks the clock is looked at again. */
const SLICE = 10

/** So many are practised between two looks at the clock, where a program asks for practice. */
const EXAMPLES = 1000

/** A lab for the screen: one view a frame, and the verbs of a child's hand. */
export class RunningLab {
  #lab: Lab = createLab()
  #pace = new Pace()
  #view = $state.raw<View>() as View
  #document = $state.raw<Document>() as Document
  #facts = $state.raw<Facts>() as Facts
  /** The frame that is asked for; 0: nothing moves; −1: no time passes. */
  #frame = -1
  #before = 0
  /** A moment that is asked for; it is shown with the next frame. */
  #wanted: number | null = null
  #chosen = $state('')
  /** Called when a run has changed a network or a table. */
  onlearned = (): void => {}
  /** Simulated seconds a real second; Infinity: as fast as it can. */
  speed = $state(1)

  readonly #effort: Pick<EffortCount, 'bumped' | 'computed'> | null

  /** @param effort counts bumps, and the time in which the first robot learns by trying */
  constructor(
    document: Document,
    floor: Floor,
    checks: readonly Check[],
    effort: Pick<EffortCount, 'bumped' | 'computed'> | null = null,
  ) {
    this.#effort = effort
    this.#lab.load(document, floor, { seed: 1, checks })
    this.#show()
  }

  /** Puts something between the screen and the lab that passes every verb on: who writes down what is done. */
  tap(put: (lab: Lab) => Lab): void {
    this.#lab = put(this.#lab)
    this.#show()
  }

  get view() {
    return this.#view
  }
  /** What seldom changes in the view. */
  get facts() {
    return this.#facts
  }
  /** Programs, brains with the weights of now, world with the start poses. */
  get document() {
    return this.#document
  }

  /** As sensors see it. */
  get floor() {
    return this.#lab.floor()
  }

  /** All of this moment: what programs remember too. */
  get moment() {
    return this.#lab.state()
  }

  /** Lets time run with the screen's frames, from now on. Returns how to stop. */
  run(): () => void {
    this.#frame = 0
    this.#wake()
    return () => this.#sleep(-1)
  }

  /** Frames are asked for while something can move, and until then not one. */
  #wake(): void {
    if (this.#frame) return
    this.#before = performance.now()
    this.#frame = requestAnimationFrame(this.#pass)
  }

  #pass = (now: number): void => {
    const running = this.#view.phase === 'running'
    // The first frame may have begun before it was asked for.
    const ticks = this.#pace.ticksFor(Math.max(0, now - this.#before), running ? this.speed : 1)
    this.#before = now
    this.#frame = requestAnimationFrame(this.#pass)
    if (this.#wanted !== null) this.goTo(this.#wanted)
    else if (this.#advance(ticks)) this.#show()
    else if (ticks > 0 && !running) this.#sleep(0)
  }

  #sleep(until: 0 | -1): void {
    cancelAnimationFrame(this.#frame)
    this.#frame = until
  }

  /** In slices: where ticks take longer than a frame has time for, there are fewer. Returns whether anything moved. */
  #advance(ticks: number): boolean {
    const begin = performance.now()
    const end = begin + BUDGET
    let moved = false
    for (let left = ticks; left > 0; left -= SLICE) {
      if (!this.#lab.advance(Math.min(left, SLICE), EXAMPLES)) break
      moved = true
      if (performance.now() > end) break
    }
    if (this.#view.robots[0]?.trying) this.#effort?.computed((performance.now() - begin) / 1000)
    return moved
  }

  #show(): void {
    this.#view = this.#lab.view(this.#chosen)
    if (!this.#view.time.past) this.#effort?.bumped(this.#view.robots[0]?.bumps ?? 0)
    this.#facts = renewed(this.#facts, factsOf(this.#view, this.#chosen))
    const { brains, tables } = this.#document ?? {}
    this.#document = this.#lab.document()
    if (
      this.#view.phase !== 'ready' &&
      (this.#document.brains !== brains || this.#document.tables !== tables)
    )
      this.onlearned()
  }

  /** Id of the robot whose networks the view has, whom keys drive and steps wait for; '' the first. */
  get chosen() {
    return this.#chosen
  }
  choose = (robot: string) => this.#then(() => (this.#chosen = robot))

  /** Asks for a moment of the run: the last one that was asked for is shown in the next frame. */
  lookAt(tick: number): void {
    this.#wanted = tick
    this.#wake()
  }

  goTo = (tick: number) =>
    this.#then(() => {
      this.#wanted = null
      this.#lab.goTo(tick)
    })
  branch = () => this.#then(() => this.#lab.branch())
  swap = () => this.#then(() => this.#lab.swap())
  start = () => this.#then(() => this.#lab.start())
  stop = () => this.#then(() => this.#lab.stop())
  pause = () => this.#then(() => this.#lab.pause())
  resume = () => this.#then(() => this.#lab.resume())
  rebuild = (...what: Parameters<Lab['rebuild']>) => this.#then(() => this.#lab.rebuild(...what))
  reset = () => this.#then(() => this.#lab.reset())
  step = (kind: StepKind) => this.#then(() => this.#lab.step(kind, this.#chosen))
  press = (key: DriveKey, down: boolean) => {
    this.#lab.press(key, down, this.#chosen)
    this.#wake()
  }
  pressButton = (key: RobotKey, down: boolean, robot: string) => {
    this.#lab.pressButton(key, down, robot)
    this.#wake()
  }
  /** A hand on the pad of the chosen robot; null: it lets go. */
  drive = (wheels: Wheels | null, others: Hand['others'] = {}) => {
    this.#lab.drive(wheels, others, this.#chosen)
    this.#wake()
  }
  record = (...what: Parameters<Lab['record']>) => this.#then(() => this.#lab.record(...what))
  remember = (...what: Parameters<Lab['remember']>) => this.#then(() => this.#lab.remember(...what))
  setTraining = (...what: Parameters<Lab['setTraining']>) => this.#then(() => this.#lab.setTraining(...what))
  setStops = (blocks: readonly string[]) => this.#lab.setStops(blocks)
  missing = () => this.#lab.missing()
  variables = (robot: string) => this.#lab.variables(robot)
  senses = (robot: string) => this.#lab.senses(robot)
  trying = (robot: string) => this.#lab.trying(robot)
  place = (...what: Parameters<Lab['place']>) => this.#then(() => this.#lab.place(...what))
  setWeight = (brain: string, from: string, to: string, weight: number, set = '') =>
    this.#then(() => this.#lab.setWeight(brain, from, to, weight, set))
  setBrain = (id: string, brain: Brain) => this.#then(() => this.#lab.setBrain(id, brain))
  edit = (...what: Parameters<Lab['edit']>) => this.#then(() => this.#lab.edit(...what))

  #then<Result>(verb: () => Result): Result {
    const result = verb()
    this.#show()
    this.#wake()
    return result
  }
}
