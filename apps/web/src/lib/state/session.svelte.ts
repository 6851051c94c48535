import type { Finding } from '@botgarten/blocks'
import type { Document, DriveKey } from '@botgarten/lab'
import {
  copyWeights,
  emptyBrain,
  weightsOf,
  withoutWeights,
  type Brain,
} from '@botgarten/learning/neural-network'
import { check, inScene, networks, sceneOf } from '@botgarten/programs'
import type { Learned, Program, Progress, Project, Scene } from '@botgarten/programs'
import type { Floor, Pose, RobotConfig } from '@botgarten/simulation'
import { Keeper } from './keeper.svelte.ts'
import { floorPictureOf, type Opened } from './opening.ts'
import { RunningLab } from './running.svelte.ts'
import { UndoStack, type Poses } from './undo.svelte.ts'

type Phase = 'start' | 'move' | 'end'

/** One project in a child's hands: its lab, its undo stack and its keeper, and nothing that is drawn. */
export class Session {
  readonly lab: RunningLab
  readonly undo: UndoStack
  readonly keeper: Keeper
  readonly opened: Opened
  /** Takes one of Blockly's own steps back or forth; the editor sets it. */
  moveBlocks: (direction: 'undo' | 'redo', program: string) => boolean = () => false
  /** Paints the floor of a scene that is taken back; who builds sets it. */
  paint: (scene: Scene) => Floor | null = () => null
  /** Start was pressed: learns first what the program wants learned. The playground sets it; true where it has begun. */
  learnFirst: () => boolean = () => this.learns
  /** Pictures of floors, those of steps that can be taken back too. */
  #pictures = $state.raw<Project['assets']>({})
  #name = $state('')
  #progress = $state.raw<Progress>({ starts: [], hints: 0 })
  #learned: NonNullable<Project['q']>
  #shelf = $state.raw<Project['shelf']>()
  /** By the id of the robot. */
  #findings = $state.raw<{ readonly [robot: string]: readonly Finding[] }>({})
  #before: { readonly pose?: Pose; readonly start?: Pose; readonly brain?: Brain } = {}
  /** Start pose that the present run began from; null once a hand has helped. */
  #startedFrom: number | null = null

  constructor(opened: Opened) {
    this.opened = opened
    const { project, card } = opened
    this.#name = project.name
    this.#learned = project.q ?? {}
    this.#shelf = project.shelf
    this.#progress = project.progress ?? { starts: [], hints: 0 }
    this.lab = new RunningLab(project, opened.floor, card?.card.checks ?? [])
    this.keeper = new Keeper(opened.id, opened.revision)
    this.keeper.whenRenamed = (name) => (this.#name = name)
    this.undo = new UndoStack({
      blocks: (direction, program) => this.#goBack(direction, program),
      robots: (document, stood) => this.#crew(document, stood),
      place: (id, pose, start) => this.#changed(() => this.lab.place(id, pose, start)),
      brain: (id, brain) => this.#changed(() => this.lab.setBrain(id, brain)),
      future: () => this.#changed(() => this.lab.swap()),
      hasFuture: () => this.lab.other,
      now: () => this.lab.view.time.now,
      config: (id, config) => this.#equip(id, config),
      scene: (scene, stood) => this.#build(scene, stood),
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
    return this.#findings[this.robotId] ?? []
  }
  get progress() {
    return this.#progress
  }
  /** The networks of the program, first the one that the playground shows. */
  get outlines() {
    return networks(this.program)
  }
  get config() {
    return this.robot.config
  }
  /** The weights that are shown: those of the moment, in the set that the robot drives with. */
  weightsIn(network: string) {
    const brain = this.lab.view.brains[network]
    return brain ? weightsOf(brain, this.robot.brain) : {}
  }

  /** The weights of the present, whatever moment is shown. */
  weightsNow(network: string) {
    return weightsOf(this.#brain(network), this.robot.brain)
  }

  /** The project as it stands now: what is kept and what a file holds. */
  get project(): Project {
    const { programs, world, brains } = this.lab.document
    const parts = { programs, world, brains, progress: this.#progress, assets: this.#pictureIn(world.floor) }
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

  /** Only the picture that lies there is kept. */
  #pictureIn(floor: Scene['floor']): Project['assets'] {
    const own = 'asset' in floor ? this.#pictures[floor.asset] : undefined
    return 'asset' in floor && own ? { [floor.asset]: own } : {}
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
    const { programs, world } = this.lab.document
    const found = world.robots.map(({ id, program, config }) => [
      id,
      check(programs[program] ?? noProgram, config),
    ])
    this.#findings = Object.fromEntries(found) as { [robot: string]: Finding[] }
  }

  /** The first robot whose program has to be mended before it can run. */
  get #stuck(): string | undefined {
    const robots = this.lab.document.world.robots.map(({ id }) => id)
    return robots.find((id) => this.#findings[id]?.some(({ stops }) => stops))
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
    this.#startedFrom = null
    this.#changed(() => this.lab.rebuild(next, undefined, stood))
    this.#look()
  }

  /** Robots came or went, with what is theirs. */
  changeCrew(after: Document): void {
    this.lab.goTo(Infinity)
    const before = this.lab.document
    const stood = this.#poses
    this.#crew(after)
    this.undo.note({ kind: 'robots', before, after: this.lab.document, stood })
  }

  editProgram(program: Program, id: string = this.robot.program): void {
    this.#changed(() => this.lab.edit({ ...this.lab.document.programs, [id]: program }))
    this.#look()
    if (this.#stuck !== undefined) this.lab.stop()
  }

  /** Duplicated neurons take the weights of their originals along. */
  copied(pairs: readonly { readonly from: string; readonly to: string }[]): void {
    for (const [id, brain] of Object.entries(this.lab.document.brains))
      this.#changed(() => this.lab.setBrain(id, copyWeights(brain, pairs)))
  }

  #brain = (id: string): Brain => this.lab.document.brains[id] ?? emptyBrain

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

  setWeight(network: string, from: string, to: string, weight: number, phase: Phase): void {
    this.goOn()
    if (phase === 'start') this.#before = { brain: this.#brain(network) }
    this.#changed(() => this.lab.setWeight(network, from, to, weight, this.robot.brain))
    const before = this.#before.brain
    const after = this.#brain(network)
    if (phase === 'end' && before && before !== after)
      this.undo.note({ kind: 'brain', id: network, before, after })
  }

  resetWeights(network: string): void {
    this.goOn()
    const before = this.#brain(network)
    const after = withoutWeights(before, this.robot.brain)
    this.#changed(() => this.lab.setBrain(network, after))
    this.undo.note({ kind: 'brain', id: network, before, after })
  }

  #startOf(id: string): Pose | undefined {
    const { robots, obstacles } = this.lab.document.world
    return [...robots, ...obstacles].find((thing) => thing.id === id)?.pose
  }

  /** Where everything stands now. */
  get #poses(): Poses {
    const { robots, obstacles } = this.lab.view
    return Object.fromEntries([...robots, ...obstacles].map(({ id, pose }) => [id, pose]))
  }

  place(id: string, pose: Pose, phase: Phase): void {
    this.goOn()
    if (phase === 'start') this.#before = { pose: this.#poses[id], start: this.#startOf(id) }
    this.#startedFrom = null
    const after = this.#changed(() => this.lab.place(id, pose))
    const { pose: before, start } = this.#before
    if (phase === 'end' && before) this.undo.note({ kind: 'place', id, before, after, start })
  }

  press(key: DriveKey, down: boolean): void {
    if (down) this.#startedFrom = null
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
    this.#startedFrom = null
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
    const stood = this.#poses
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
    const pose = this.lab.document.world.robots[0]?.pose
    return this.opened.card?.card.starts.findIndex((start) => samePose(start, pose)) ?? -1
  }

  /** Begins a run. Returns the finding that keeps it from running, if there is one. */
  start(): Finding | null {
    const stuck = this.#stuck
    if (stuck !== undefined) {
      this.choose(stuck)
      return this.findings.find(({ stops }) => stops) ?? null
    }
    if (this.learnFirst()) return null
    const standsAt = this.lab.view.robots[0]?.pose
    const card = this.opened.card?.card
    // Who learned a way starts where the way does.
    this.#startedFrom =
      card?.playground === 'q-learning'
        ? 0
        : (card?.starts.findIndex((start) => samePose(start, standsAt)) ?? -1)
    this.lab.start()
    this.undo.begin()
    return null
  }

  /** Hertz of the tone that is heard: the chosen robot's, else that of the first one that sounds. */
  get heard(): number | null {
    const { robots } = this.lab.view
    const chosen = robots.find(({ id }) => id === this.robotId)
    return chosen?.frequency ?? robots.find(({ frequency }) => frequency)?.frequency ?? null
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

/** The block that says on which map. */
const learningMap = '"ai_q_learning_states_and_actions_map"'

const noProgram: Program = { stacks: [], config: { stacks: [] } }

const samePose = (a: Pose, b: Pose | undefined) =>
  b !== undefined && Math.abs(a.x - b.x) + Math.abs(a.y - b.y) + Math.abs(a.heading - b.heading) < 1e-6
