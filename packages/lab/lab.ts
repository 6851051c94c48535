import { emptyBrain, withWeight, type Brain } from '@botgarten/learning/neural-network'
import { hex } from '@botgarten/numbers'
import { createSimulation, freshRobot, type Floor, type Pose, type Simulation } from '@botgarten/simulation'
import { brainsFor } from './robots/brains.ts'
import { Run } from './run.ts'
import type { Check, Document, DriveKey, Input, Lab, Phase, StepKind } from './types.ts'
import { viewOf } from './view.ts'

/** Ticks after which a step gives up waiting for a block or a net: ten seconds. */
const STEP_LIMIT = 600

/** An empty lab; `load` gives it something to run. */
export const createLab = (): Lab => new OneLab()

class OneLab implements Lab {
  #document: Document = { programs: {}, world: emptyWorld, brains: {} }
  #floor: Floor = { width: 1, height: 1, pixelsPerCm: 1, data: new Uint8Array(3) }
  #options: { readonly seed: number; readonly checks: readonly Check[] } = { seed: 0, checks: [] }
  #phase: Phase = 'ready'
  #simulation!: Simulation
  #run!: Run

  load(
    document: Document,
    floor: Floor,
    options: { readonly seed: number; readonly checks: readonly Check[] },
  ): void {
    this.#document = { ...document, brains: brainsFor(document.programs, document.brains) }
    this.#floor = floor
    this.#options = options
    this.reset()
  }

  reset(): void {
    this.#phase = 'ready'
    this.#simulation = createSimulation(this.#document.world, this.#floor, this.#options.seed)
    this.#begin([])
  }

  /** A new run from what stands in the world now: the same start state, seed and inputs give the same run (running.md 2). */
  #begin(keys: readonly DriveKey[]): void {
    const { noise } = createSimulation(this.#document.world, this.#floor, this.#options.seed).state
    this.#simulation.restore({ ...this.#simulation.keyframe(), tick: 0, noise })
    this.#run = new Run(
      this.#simulation,
      this.#document.programs,
      this.#document.brains,
      this.#options.checks,
      keys,
    )
  }

  edit(programs: Document['programs']): void {
    const moved = sameBlocks(programs, this.#document.programs)
    this.#document = { ...this.#document, programs, brains: brainsFor(programs, this.#document.brains) }
    if (!moved) this.#begin(this.#run.keys)
  }

  start(): void {
    for (const robot of this.#simulation.state.robots) freshRobot(robot)
    this.#begin(this.#run.keys)
    this.#phase = 'running'
  }

  stop(): void {
    for (const { context } of this.#run.robots) {
      context.robot.stop()
      context.robot.tone(0, null)
    }
    this.#phase = 'ready'
  }

  pause(): void {
    if (this.#phase === 'running') this.#phase = 'paused'
  }

  resume(): void {
    if (this.#phase === 'paused') this.#phase = 'running'
  }

  step(kind: StepKind): void {
    if (this.#phase === 'ready' || this.#phase === 'ended') this.start()
    this.#phase = 'paused'
    if (kind === 'tick') this.#tick()
    else if (kind === 'block') this.#stepBlock()
    else this.#stepNetwork()
  }

  #stepBlock(): void {
    for (let ticks = 0; ticks < STEP_LIMIT && this.#phase === 'paused'; ticks++) {
      const blocks = this.#run.robots[0]?.thread.started
      if (!this.#run.runThreads(true) || this.#run.robots[0]?.thread.started !== blocks) return
      this.#tick()
    }
  }

  #stepNetwork(): void {
    const runs = this.#run.robots[0]?.brains.runs
    for (let ticks = 0; ticks < STEP_LIMIT && this.#phase === 'paused'; ticks++) {
      this.#tick()
      if (this.#run.robots[0]?.brains.runs !== runs) return
    }
  }

  advance(ticks: number): boolean {
    let moved = false
    for (let tick = 0; tick < ticks; tick++) {
      if (this.#phase === 'running') {
        this.#tick()
        moved = true
      } else if (this.#phase !== 'paused') moved = this.#run.idle() || moved
    }
    return moved
  }

  #tick(): void {
    this.#run.advance()
    if (this.#run.isOver) {
      this.stop()
      this.#phase = 'ended'
    }
  }

  setWeight(brain: string, from: string, to: string, weight: number): void {
    this.setBrain(brain, withWeight(this.#document.brains[brain] ?? emptyBrain, from, to, weight))
  }

  setBrain(brain: string, value: Brain): void {
    this.#document = { ...this.#document, brains: { ...this.#document.brains, [brain]: value } }
    this.#give({ kind: 'brain', brain, value })
  }

  place(id: string, pose: Pose): Pose {
    this.#give({ kind: 'place', id, pose })
    const came = this.#run.poseOf(id) ?? pose
    const robotRuns = this.#phase === 'running' || this.#phase === 'paused'
    this.#document = { ...this.#document, world: placed(this.#document.world, id, came, !robotRuns) }
    return came
  }

  press(key: DriveKey, down: boolean): void {
    this.#give({ kind: 'key', key, down })
  }

  #give(input: Input): void {
    this.#run.give(input)
  }

  goTo(tick: number): void {
    this.#run.goTo(tick)
    this.#document = { ...this.#document, brains: this.#run.brains }
    this.#phase = 'paused'
  }

  state = () => this.#run.moment()
  view = () => viewOf(this.#run, this.#phase)
  document = () => this.#document
  hash = () => hex(this.#run.hash)
}

/** Is it the same program, at most laid out differently on the canvas? */
const sameBlocks = (a: Document['programs'], b: Document['programs']) => meaningOf(a) === meaningOf(b)

const meaningOf = (programs: Document['programs']) =>
  JSON.stringify(Object.entries(programs).map(([id, { stacks }]) => [id, stacks.map(({ blocks }) => blocks)]))

const emptyWorld: Document['world'] = {
  size: { width: 100, height: 100 },
  floor: { colour: '#FFFFFF' },
  areas: [],
  lines: [],
  obstacles: [],
  robots: [],
}

/** The world with a thing's start pose changed; robots keep theirs while they run. */
function placed(world: Document['world'], id: string, pose: Pose, robotsToo: boolean): Document['world'] {
  const put = <Thing extends { id: string; pose: Pose }>(things: readonly Thing[]) =>
    things.map((thing) => (thing.id === id ? { ...thing, pose } : thing))
  return { ...world, obstacles: put(world.obstacles), robots: robotsToo ? put(world.robots) : world.robots }
}
