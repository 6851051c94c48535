import type { Finding } from '@botgarten/blocks'
import type { DriveKey } from '@botgarten/lab'
import type { Brain } from '@botgarten/learning/neural-network/brain'
import { networksByUse, tryingIn } from '@botgarten/programs'
import type { Learned, OwnCard, Project, Scene } from '@botgarten/programs'
import { ownCardId } from '#content/cards.ts'
import type { Floor, Pose } from '@botgarten/simulation'
import { allowed } from './allowed.svelte.ts'
import type { Slots } from './slots.ts'
import { backFrom, type Change, type LabEvent, type Part } from './change.ts'
import { execute } from './execute.ts'
import { EffortCount } from './effort.ts'
import { Extras } from './extras.svelte.ts'
import { Findings, noProgram } from './findings.svelte.ts'
import { ProjectAutosave, savesTo } from './autosave.svelte.ts'
import { floorPictureOf, type Opened } from './opening.ts'
import { CardProgress } from './progress.svelte.ts'
import { RunningLab } from './running.svelte.ts'
import { UndoStack } from './undo.svelte.ts'
import { HandOnExamples } from './examples.ts'
import { HandOnWeights } from './weights.ts'

/** In a moment of the past these make another future (running.md 9). */
const goesOn: readonly Change['kind'][] = ['place', 'weight', 'brain', 'examples', 'practice']

/** A map under a floor. */
export interface MapBelow {
  /** Address of its picture. */
  readonly url: string
  /** Middles of its stations by their numbers, in cm, y up. */
  readonly stations: readonly { readonly x: number; readonly y: number }[]
}

/** One project in a child's hands: its running lab, and `apply`, through which every edit goes. Nothing here is drawn. */
export class LabSession {
  readonly lab: RunningLab
  readonly undo: UndoStack
  readonly autosave: ProjectAutosave
  readonly weights: HandOnWeights
  readonly examples: HandOnExamples
  /** What goes into the project. */
  readonly effort: EffortCount
  readonly opened: Opened
  /** Takes one of Blockly's own steps back or forth; the editor sets it. */
  moveBlocks: (direction: 'undo' | 'redo', program: string) => boolean = () => false
  /** What a hand has done to the blocks so far is a change now; false while it holds one. The editor sets it. */
  settleBlocks: () => boolean = () => true
  /** Does another child edit it, too? */
  shared = $state(false)
  /** Paints the floor of a scene that is taken back; who builds sets it. */
  paint: (scene: Scene) => Floor | null = () => null
  /** Start was pressed: learns first what the program wants learned. The playground sets it; true where it has begun. */
  learnFirst: () => boolean = () => this.learns
  /** Poses from which a run counts: those of the card, or where the way that was learned begins. The playground sets it. */
  starts: () => readonly Pose[] = () => this.opened.card?.card.starts ?? []
  /** What is looked at inside the network; there from the first question on. */
  inside = $state.raw<Slots['inside'] | null>(null)
  /** How its networks learn from examples; there once a child has asked. */
  training = $state.raw<Slots['training'] | null>(null)
  /** What the robot learns by trying with its own sensors; there once a program does so. */
  senses = $state.raw<Slots['senses'] | null>(null)
  /** What lies under a floor that has no picture: the map from which the way was drawn. */
  below = $state.raw<MapBelow | null>(null)
  readonly #extras: Extras
  readonly #progress: CardProgress
  readonly #findings: Findings
  #settlers: readonly ((change: Change | null) => void)[] = []
  #listeners: readonly ((event: LabEvent) => void)[] = []
  /** Index of the card's start pose that was chosen last. */
  #lastStart = 0
  /** Takes the pull back that a hand is in the middle of. */
  #pulled: Change | null = null

  constructor(opened: Opened) {
    this.opened = opened
    const { project, card } = opened
    this.#extras = new Extras(project)
    this.#progress = new CardProgress(card?.card, project.progress, () => this.starts())
    this.effort = new EffortCount(project.effort)
    this.lab = new RunningLab(project, opened.floor, card?.card.checks ?? [], this.effort)
    this.weights = new HandOnWeights(this)
    this.examples = new HandOnExamples(this)
    this.#findings = new Findings(() => this.lab.document, project)
    this.undo = new UndoStack({
      apply: (change, part) => this.apply(change, part),
      hasFuture: () => this.lab.facts.other,
      now: () => this.lab.view.time.now,
      settle: () => this.#settle(null),
    })
    this.autosave = new ProjectAutosave(opened.id, opened.revision)
    this.autosave.whenRenamed = (name) => (this.#extras.name = name)
    // What can be kept nowhere is not called saved, not even before the first change.
    if (!opened.keeps) this.autosave.changed(() => this.project)
    this.listen(this.#findings.hear)
    this.listen(this.undo.hear)
    this.listen(this.effort.hear)
    this.listen(savesTo(this.autosave, () => this.project))
    this.lab.onlearned = () => this.autosave.learned(() => this.project)
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
    return this.#extras.projectOf(this.lab.document, this.progress, this.effort.sum)
  }
  get name() {
    return this.#extras.name
  }
  get pictures() {
    return this.#extras.pictures
  }
  /** Maps of its own. */
  get maps(): NonNullable<Project['maps']> {
    return this.opened.project.maps ?? {}
  }
  /** Address of the floor's picture, null where it has none. */
  floorUrl = $derived.by(() => floorPictureOf(this.lab.document.world, this.pictures))

  /** The card that somebody has made and that is played here. */
  get ownCard(): OwnCard | null {
    const { card, project } = this.opened
    return card?.card.id === ownCardId ? (project.ownCard ?? null) : null
  }
  /** May the child choose between the two toolboxes? */
  get choosesBlocks(): boolean {
    return allowed.level === null && this.ownCard === null
  }
  /** Is the toolbox with every block shown? Where nobody has said so, a program that holds more comes with it. */
  get showsAll(): boolean {
    if (allowed.level !== null) return allowed.level === 'all'
    if (this.ownCard) return this.ownCard.blocks.level === 'all'
    const { shelf } = this.#extras
    return shelf ? shelf === 'all' : this.opened.expert
  }

  /** Does the program learn by trying? Its playground is shown then. */
  learns = $derived.by(() => JSON.stringify(this.program.stacks).includes(learningMap))

  /** Does the robot try with its own sensors? */
  tries = $derived.by(() => tryingIn(this.program) !== null)

  /** How far the chosen robot's learning by trying has come. */
  get learned(): Learned | undefined {
    return this.#extras.learnedBy(this.robot.program)
  }

  /** Is told of every change after it has happened. Returns how to listen no more. */
  listen(listener: (event: LabEvent) => void): () => unknown {
    this.#listeners = [...this.#listeners, listener]
    return () => (this.#listeners = this.#listeners.filter((one) => one !== listener))
  }

  /**
   * Is asked before every step, and with null before the last one is taken back: what is under way becomes a step of its own
   * first.
   */
  settles(settler: (change: Change | null) => void): void {
    this.#settlers = [...this.#settlers, settler]
  }

  #settle(change: Change | null): void {
    for (const settler of this.#settlers) settler(change)
  }

  #tell(event: LabEvent): void {
    for (const listener of this.#listeners) listener(event)
  }

  /** Changes the project, and tells all who listen. Returns whether anything has changed. */
  apply(change: Change, part: Part = 'whole'): boolean {
    if (part !== 'silent') this.#settle(change)
    if (part !== 'silent' && goesOn.includes(change.kind)) this.goOn()
    // Who comes or goes does so now.
    if (change.kind === 'robots') this.lab.goTo(Infinity)
    const before = backFrom(change, this.lab)
    const done = execute(change, this, { extras: this.#extras, progress: this.#progress })
    if (!done) return false
    this.effort.change(change, part)
    if (part === 'start') this.#pulled = before
    const back = { whole: before, joined: before, start: null, move: null, end: this.#pulled, silent: null }[
      part
    ]
    if (part === 'end') this.#pulled = null
    const same = back !== null && 'after' in back && 'after' in done && back.after === done.after
    this.#tell({ kind: 'changed', change: done, back: same ? null : back, joined: part === 'joined' })
    if (halts.includes(change.kind) && this.#findings.stuck !== undefined) this.lab.stop()
    return true
  }

  /** Rows were written by the run itself, or by a hand that remembers: they can be taken back, and are saved. */
  noteExamples(network: string, before: Brain['examples']): void {
    const after = this.lab.document.brains[network]?.examples
    if (after === before) return
    const change = { kind: 'examples', network, after } as const
    this.#tell({ kind: 'changed', change, back: { ...change, after: before }, joined: false })
  }

  /** Blockly has taken a step of its own: it can be taken back there. */
  noteBlocks(program: string): void {
    const blocks = (direction: 'undo' | 'redo') => ({ kind: 'blocks', program, direction }) as const
    this.#settle(blocks('redo'))
    this.#tell({ kind: 'changed', change: blocks('redo'), back: blocks('undo'), joined: false })
  }

  /** A hand changes something in a moment of the past: that is the present from here on (running.md 9). */
  goOn(): void {
    const { tick, time } = this.lab.view
    if (!time.past) return
    this.lab.branch()
    this.#tell({ kind: 'branched', tick })
  }

  resume(): void {
    this.goOn()
    this.lab.resume()
  }

  /** Gives the project another name, which is saved like every change. */
  rename(name: string): void {
    this.#extras.name = name
    this.autosave.changed(() => this.project)
  }

  /** From here on this is a project of its own. */
  continueAsCopy(id: string, name: string): Promise<void> {
    this.#extras.name = name
    return this.autosave.continueAs(id, () => this.project)
  }

  choose(robot: string): void {
    this.lab.choose(robot)
  }

  press(key: DriveKey, down: boolean): void {
    if (down) this.#progress.helped()
    this.effort.touch()
    this.lab.press(key, down)
  }

  /** Puts the robot on one of the start poses. */
  chooseStart(index: number): void {
    const pose = this.starts()[index]
    const robot = this.lab.view.robots[0]
    if (!pose || !robot) return
    this.#lastStart = index
    this.lab.reset()
    this.apply({ kind: 'place', id: robot.id, after: pose })
  }

  /** Puts everything back. On a card the robot comes to a start pose that counts, even if it was moved by hand before. */
  toStart(): void {
    this.lab.reset()
    if (this.opened.card && this.chosenStart < 0) this.chooseStart(this.#lastStart)
  }

  /** Index of the start pose the robot is set on, −1 for another place. */
  get chosenStart(): number {
    return this.#progress.startAt(this.lab.document.world.robots[0]?.pose)
  }

  /** Begins a run. Returns the finding that keeps it from running, if there is one. */
  start(): Finding | null {
    const { stuck } = this.#findings
    if (stuck !== undefined) {
      this.choose(stuck)
      return this.findings.find(({ stops }) => stops) ?? null
    }
    if (this.learnFirst()) return null
    this.lab.start()
    this.#progress.begin(this.lab.view.robots[0]?.pose)
    this.#tell({ kind: 'begun' })
    return null
  }

  /** The run has begun somewhere else than the card's start poses: it cannot count. */
  get beganElsewhere(): boolean {
    return this.#progress.beganElsewhere
  }

  /** All checks are green: notes from which start pose. Returns whether that counts. */
  noteSuccess(): boolean {
    const { solved } = this.#progress
    if (solved) this.apply({ kind: 'progress', after: solved })
    return this.#progress.counts
  }

  askHint(shown: number): void {
    const { hints } = this.progress
    this.apply({ kind: 'progress', after: { ...this.progress, hints: Math.max(shown, hints) } })
  }
}

/** After these a program that has to be fixed first runs no longer. */
const halts: readonly Change['kind'][] = ['program', 'config']

/** The block that says on which map. */
const learningMap = '"ai_q_learning_states_and_actions_map"'
