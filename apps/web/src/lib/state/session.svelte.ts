import type { Finding } from '@botgarten/blocks'
import type { DriveKey } from '@botgarten/lab'
import { copyWeights, emptyBrain, withoutWeights, type Brain } from '@botgarten/learning/neural-network'
import { check, networks, type Program, type Progress, type Project } from '@botgarten/programs'
import type { Pose } from '@botgarten/simulation'
import { Keeper } from './keeper.svelte.ts'
import type { Opened } from './opening.ts'
import { RunningLab } from './running.svelte.ts'
import { UndoStack } from './undo.svelte.ts'

type Phase = 'start' | 'move' | 'end'

/** One project in a child's hands: its lab, its undo stack and its keeper, and nothing that is drawn. */
export class Session {
  readonly lab: RunningLab
  readonly undo: UndoStack
  readonly keeper: Keeper
  readonly opened: Opened
  /** Takes one of Blockly's own steps back or forth; the editor sets it. */
  moveBlocks: (direction: 'undo' | 'redo') => boolean = () => false
  #name = $state('')
  #program = $state.raw<Program>() as Program
  #progress = $state.raw<Progress>({ starts: [], hints: 0 })
  #findings = $state.raw<readonly Finding[]>([])
  #before: { readonly pose?: Pose; readonly brain?: Brain } = {}
  /** Start pose that the present run began from; null once a hand has helped. */
  #startedFrom: number | null = null

  constructor(opened: Opened) {
    this.opened = opened
    const { project, card } = opened
    this.#name = project.name
    this.#program = project.programs[this.#programId(project)]!
    this.#progress = project.progress ?? { starts: [], hints: 0 }
    this.lab = new RunningLab(project, opened.floor, card?.card.checks ?? [])
    this.keeper = new Keeper(opened.id, opened.revision)
    this.undo = new UndoStack({
      blocks: (direction) => this.moveBlocks(direction),
      place: (id, pose) => this.#changed(() => this.lab.place(id, pose)),
      brain: (id, brain) => this.#changed(() => this.lab.setBrain(id, brain)),
    })
    this.#look()
  }

  #programId = (project: Project) => project.world.robots[0]?.program ?? 'main'

  get program() {
    return this.#program
  }
  get findings() {
    return this.#findings
  }
  get progress() {
    return this.#progress
  }
  /** The networks of the program, first the one that the playground shows. */
  get outlines() {
    return networks(this.#program)
  }
  get config() {
    return this.lab.document.world.robots[0]!.config
  }

  /** The project as it stands now: what is kept and what a file holds. */
  get project(): Project {
    const { programs, world, brains } = this.lab.document
    return { ...this.opened.project, name: this.#name, programs, world, brains, progress: this.#progress }
  }

  get name() {
    return this.#name
  }

  /** From here on this is a project of its own. */
  continueAsCopy(id: string, name: string): Promise<void> {
    this.#name = name
    return this.keeper.continueAs(id, () => this.project)
  }

  #changed<Result>(change: () => Result): Result {
    const result = change()
    this.keeper.changed(() => this.project)
    return result
  }

  #look(): void {
    this.#findings = check(this.#program, this.config)
  }

  editProgram(program: Program): void {
    this.#program = program
    this.#changed(() =>
      this.lab.edit({ ...this.lab.document.programs, [this.#programId(this.project)]: program }),
    )
    this.#look()
    if (this.#findings.some(({ stops }) => stops)) this.lab.stop()
  }

  /** Duplicated neurons take the weights of their originals along. */
  copied(pairs: readonly { readonly from: string; readonly to: string }[]): void {
    for (const [id, brain] of Object.entries(this.lab.document.brains))
      this.#changed(() => this.lab.setBrain(id, copyWeights(brain, pairs)))
  }

  #brain = (id: string): Brain => this.lab.document.brains[id] ?? emptyBrain

  setWeight(network: string, from: string, to: string, weight: number, phase: Phase): void {
    if (phase === 'start') this.#before = { brain: this.#brain(network) }
    this.#changed(() => this.lab.setWeight(network, from, to, weight))
    const before = this.#before.brain
    const after = this.#brain(network)
    if (phase === 'end' && before && before.weights !== after.weights)
      this.undo.note({ kind: 'brain', id: network, before, after })
  }

  resetWeights(network: string): void {
    const before = this.#brain(network)
    const after = withoutWeights(before)
    this.#changed(() => this.lab.setBrain(network, after))
    this.undo.note({ kind: 'brain', id: network, before, after })
  }

  #poseOf(id: string): Pose | undefined {
    const { robots, obstacles } = this.lab.view
    return [...robots, ...obstacles].find((thing) => thing.id === id)?.pose
  }

  place(id: string, pose: Pose, phase: Phase): void {
    if (phase === 'start') this.#before = { pose: this.#poseOf(id) }
    this.#startedFrom = null
    const after = this.#changed(() => this.lab.place(id, pose))
    const before = this.#before.pose
    if (phase === 'end' && before) this.undo.note({ kind: 'place', id, before, after })
  }

  press(key: DriveKey, down: boolean): void {
    if (down) this.#startedFrom = null
    this.lab.press(key, down)
  }

  /** Puts the robot on one of the card's start poses. */
  chooseStart(index: number): void {
    const pose = this.opened.card?.card.starts[index]
    const robot = this.lab.view.robots[0]
    if (!pose || !robot) return
    this.lab.reset()
    this.#before = {}
    this.place(robot.id, pose, 'start')
    this.place(robot.id, pose, 'end')
  }

  /** Index of the start pose the robot is set on, −1 for another place. */
  get chosenStart(): number {
    const pose = this.lab.document.world.robots[0]?.pose
    return this.opened.card?.card.starts.findIndex((start) => samePose(start, pose)) ?? -1
  }

  /** Begins a run. Returns the finding that keeps it from running, if there is one. */
  start(): Finding | null {
    const finding = this.#findings.find(({ stops }) => stops)
    if (finding) return finding
    const standsAt = this.lab.view.robots[0]?.pose
    this.#startedFrom = this.opened.card?.card.starts.findIndex((start) => samePose(start, standsAt)) ?? -1
    this.lab.start()
    return null
  }

  /** All checks of the card are green at this moment. */
  get succeeded(): boolean {
    const { checks } = this.lab.view
    return checks.length > 0 && checks.every(({ passed }) => passed)
  }

  /** The robot of a card has run into something. In the free lab pushing is no mistake. */
  get bumped(): boolean {
    const { phase, robots } = this.lab.view
    return this.opened.card !== null && phase === 'running' && (robots[0]?.touching.length ?? 0) > 0
  }

  /** Notes from which start pose the card was solved. */
  noteSuccess(): void {
    const from = this.#startedFrom
    if (from === null || from < 0 || this.#progress.starts.includes(from)) return
    this.#progress = { ...this.#progress, starts: [...this.#progress.starts, from].sort() }
    this.keeper.changed(() => this.project)
  }

  askHint(shown: number): void {
    this.#progress = { ...this.#progress, hints: Math.max(shown, this.#progress.hints) }
    this.keeper.changed(() => this.project)
  }
}

const samePose = (a: Pose, b: Pose | undefined) =>
  b !== undefined && Math.abs(a.x - b.x) + Math.abs(a.y - b.y) + Math.abs(a.heading - b.heading) < 1e-6
