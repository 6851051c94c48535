import type { Finding } from '@botgarten/blocks'
import type { Document, DriveKey } from '@botgarten/lab'
import { inScene, networksByUse, sceneOf } from '@botgarten/programs'
import type { Learned, Program, Project, Scene } from '@botgarten/programs'
import type { Floor, Pose, RobotConfig } from '@botgarten/simulation'
import type { Inside } from '#features/inside/later.ts'
import { Findings, noProgram } from './findings.svelte.ts'
import { Keeper } from './keeper.svelte.ts'
import { floorPictureOf, ownPictureIn, type Opened } from './opening.ts'
import { posesOf, type Poses } from './poses.ts'
import { CardProgress } from './progress.svelte.ts'
import { RunningLab } from './running.svelte.ts'
import { UndoStack } from './undo.svelte.ts'
import { HandOnWeights } from './weights.ts'

type Phase = 'start' | 'move' | 'end'

/** One project in a child's hands: its lab, its undo stack and its keeper, and nothing that is drawn. */
export class Session {
  readonly lab: RunningLab
  readonly undo: UndoStack
  readonly keeper: Keeper
  readonly weights: HandOnWeights
  readonly opened: Opened
  /** Takes one of Blockly's own steps back or forth; the editor sets it. */
  moveBlocks: (direction: 'undo' | 'redo', program: string) => boolean = () => false
  /** Paints the floor of a scene that is taken back; who builds sets it. */
  paint: (scene: Scene) => Floor | null = () => null
  /** Start was pressed: learns first what the program wants learned. The playground sets it; true where it has begun. */
  learnFirst: () => boolean = () => this.learns
  /** What is looked at inside the network; there from the first question on. */
  inside = $state.raw<Inside | null>(null)
  /** Pictures of floors, those of steps that can be taken back too. */
  #pictures = $state.raw<Project['assets']>({})
  #name = $state('')
  readonly #progress: CardProgress
  #learned: NonNullable<Project['q']>
  #shelf = $state.raw<Project['shelf']>()
  readonly #findings = new Findings()
  #before: { readonly pose?: Pose; readonly start?: Pose } = {}

  constructor(opened: Opened) {
    this.opened = opened
    const { project, card } = opened
    this.#name = project.name
    this.#learned = project.q ?? {}
    this.#shelf = project.shelf
    this.#progress = new CardProgress(card?.card, project.progress)
    this.lab = new RunningLab(project, opened.floor, card?.card.checks ?? [])
    this.keeper = new Keeper(opened.id, opened.revision)
    this.keeper.whenRenamed = (name) => (this.#name = name)
    // What can be kept nowhere is not called saved, not even before the first change.
    if (!opened.keeps) this.keeper.changed(() => this.project)
    this.undo = new UndoStack({
      blocks: (direction, program) => this.#goBack(direction, program),
      robots: (document, stood) => this.#crew(document, stood),
      place: (id, pose, start) => {
        this.#progress.helped()
        this.#changed(() => this.lab.place(id, pose, start))
      },
      brain: (id, brain) => this.#changed(() => this.lab.setBrain(id, brain)),
      future: () => this.#changed(() => this.lab.swap()),
      hasFuture: () => this.lab.facts.other,
      now: () => this.lab.view.time.now,
      config: (id, config) => this.#equip(id, config),
      scene: (scene, stood) => this.#build(scene, stood),
    })
    this.weights = new HandOnWeights({
      ...{ lab: this.lab, undo: this.undo, set: () => this.robot.brain },
      ...{ goOn: () => this.goOn(), changed: (change) => this.#changed(change) },
    })
    this.#pictures = project.assets
    this.#look()
  }

  /** The robot whose program and network are on the screen. */
  readonly robot = $derived.by(() => {
    const { robots } = this.lab.document.world
    return robots.find(({ id }) => id === this.lab.chosen) ?? robots[0]!
  })
  get robotId() {
    return this.robot.id
  }
  readonly program = $derived.by(() => this.lab.document.programs[this.robot.program] ?? noProgram)
  get findings() {
    return this.#findings.of(this.robotId)
  }
  get progress() {
    return this.#progress.now
  }
  /** The networks of the program, first the one that the playground shows. */
  readonly outlines = $derived.by(() => networksByUse(this.program))
  get config() {
    return this.robot.config
  }
  /** The project as it stands now: what is kept and what a file holds. */
  get project(): Project {
    const { programs, world, brains } = this.lab.document
    const parts = {
      programs,
      world,
      brains,
      progress: this.progress,
      assets: ownPictureIn(world.floor, this.#pictures),
    }
    const learned = Object.keys(this.#learned).length > 0 && { q: this.#learned }
    const shelf = this.#shelf && { shelf: this.#shelf }
    return { ...this.opened.project, name: this.#name, ...parts, ...learned, ...shelf }
  }

  /** Is the shelf with every block shown? Where nobody has said so, a program that holds more comes with it. */
  get showsAll(): boolean {
    return this.#shelf ? this.#shelf === 'all' : this.opened.expert
  }

  showAll(all: boolean): void {
    this.#shelf = all ? 'all' : 'plain'
    this.keeper.changed(() => this.project)
  }

  /** Does the program learn by trying? Its playground is shown then. */
  learns = $derived.by(() => JSON.stringify(this.program.stacks).includes(learningMap))

  /** How far the chosen robot's learning by trying has come. */
  get learned(): Learned | undefined {
    return this.#learned[this.robot.program]
  }

  keepLearned(learned: Learned): void {
    this.#learned = { ...this.#learned, [this.robot.program]: learned }
    this.keeper.changed(() => this.project)
  }

  get pictures() {
    return this.#pictures
  }

  /** Address of the floor's picture, null where it has none. */
  floorUrl = $derived.by(() => floorPictureOf(this.lab.document.world, this.#pictures))

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
    this.#findings.look(this.lab.document)
  }

  /** The first robot whose program has to be mended before it can run. */
  get #stuck(): string | undefined {
    return this.#findings.stuck(this.lab.document)
  }

  choose(robot: string): void {
    this.lab.choose(robot)
  }

  /** Blocks are taken back where they are seen. */
  #goBack(direction: 'undo' | 'redo', program: string): boolean {
    const own = this.lab.document.world.robots.find((robot) => robot.program === program)
    if (own && this.robot.program !== program) this.choose(own.id)
    return this.moveBlocks(direction, program)
  }

  #crew(document: Document, stood?: Poses): void {
    const { world } = this.lab.document
    const next = { ...document, world: { ...world, robots: document.world.robots } }
    this.#progress.helped()
    this.#changed(() => this.lab.rebuild(next, undefined, stood))
    this.#look()
  }

  /** Robots came or went, with what is theirs. */
  changeCrew(after: Document): void {
    this.lab.goTo(Infinity)
    const [before, stood] = [this.lab.document, posesOf(this.lab.view)]
    this.#crew(after)
    this.undo.note({ kind: 'robots', before, after: this.lab.document, stood })
  }

  editProgram(program: Program, id: string = this.robot.program): void {
    this.#changed(() => this.lab.edit({ ...this.lab.document.programs, [id]: program }))
    // Other blocks are another run, from where Bo stands now.
    if (this.lab.view.tick === 0) this.#progress.begin(this.lab.view.robots[0]?.pose)
    this.#look()
    if (this.#stuck !== undefined) this.lab.stop()
  }

  /** A hand changes something in a moment of the past: that is the present from here on (running.md 9). */
  goOn(): void {
    const { tick, time } = this.lab.view
    if (!time.past) return
    this.#changed(() => this.lab.branch())
    this.undo.branch(tick)
  }

  resume(): void {
    this.goOn()
    this.lab.resume()
  }

  place(id: string, pose: Pose, phase: Phase): void {
    this.goOn()
    if (phase === 'start')
      this.#before = { pose: posesOf(this.lab.view)[id], start: posesOf(this.lab.document.world)[id] }
    this.#progress.helped()
    const after = this.#changed(() => this.lab.place(id, pose))
    const { pose: before, start } = this.#before
    if (phase === 'end' && before) this.undo.note({ kind: 'place', id, before, after, start })
  }

  press(key: DriveKey, down: boolean): void {
    if (down) this.#progress.helped()
    this.lab.press(key, down)
  }

  #equip(id: string, config: RobotConfig): void {
    const { document } = this.lab
    const robots = document.world.robots.map((robot) => (robot.id === id ? { ...robot, config } : robot))
    this.#changed(() => this.lab.rebuild({ ...document, world: { ...document.world, robots } }))
    this.#look()
    if (this.#stuck !== undefined) this.lab.stop()
  }

  /** Another configuration for a robot, in effect at once. `joined`: one step with what was done before it. */
  equip(id: string, config: RobotConfig, joined = false): void {
    const before = this.lab.document.world.robots.find((robot) => robot.id === id)?.config
    if (!before || JSON.stringify(before) === JSON.stringify(config)) return
    this.#equip(id, config)
    this.undo.note({ kind: 'config', id, before, after: config, joined })
  }

  #build(scene: Scene, stood?: Poses): void {
    const { document } = this.lab
    this.#progress.helped()
    this.#changed(() =>
      this.lab.rebuild(
        { ...document, world: inScene(document.world, scene) },
        this.paint(scene) ?? undefined,
        stood,
      ),
    )
  }

  /** A child has built: another scene takes the place of this one. `pictures`: new ones that lie in it. */
  build(scene: Scene, pictures: Project['assets'] = {}): void {
    const before = sceneOf(this.lab.document.world)
    const stood = posesOf(this.lab.view)
    this.#pictures = { ...this.#pictures, ...pictures }
    this.#build(scene)
    this.undo.note({ kind: 'scene', before, after: sceneOf(this.lab.document.world), stood })
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
    return this.#progress.startAt(this.lab.document.world.robots[0]?.pose)
  }

  /** Begins a run. Returns the finding that keeps it from running, if there is one. */
  start(): Finding | null {
    const stuck = this.#stuck
    if (stuck !== undefined) {
      this.choose(stuck)
      return this.findings.find(({ stops }) => stops) ?? null
    }
    if (this.learnFirst()) return null
    this.lab.start()
    this.#progress.begin(this.lab.view.robots[0]?.pose)
    this.undo.begin()
    return null
  }

  /** The run has begun somewhere else than the card's start poses: it cannot count. */
  get beganElsewhere(): boolean {
    return this.#progress.beganElsewhere
  }

  /** All checks are green: notes from which start pose. Returns whether that counts. */
  noteSuccess(): boolean {
    if (this.#progress.solved()) this.keeper.changed(() => this.project)
    return this.#progress.counts
  }

  askHint(shown: number): void {
    this.#progress.askHint(shown)
    this.keeper.changed(() => this.project)
  }
}

/** The block that says on which map. */
const learningMap = '"ai_q_learning_states_and_actions_map"'
