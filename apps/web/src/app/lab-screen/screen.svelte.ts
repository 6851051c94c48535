import { createContext, tick } from 'svelte'
import type { Difference } from '@botgarten/programs/open-roberta'
import { textOf } from '#figures/card/face.ts'
import { HandingOut } from '../handing-out.svelte.ts'
import { Robots } from '#features/robots/feature.ts'
import type { Held } from '#lab/blocks.ts'
import { inside } from '#features/inside/feature.ts'
import type { Together } from '#features/class/feature.ts'
import type { Code } from '#features/python/feature.ts'
import type { Learner } from '#features/q-learning/feature.ts'
import { applyFix } from '#features/robot/feature.ts'
import { training } from '#features/training/feature.ts'
import { Guide, sightOf } from '#features/tour/feature.ts'
import { BuildMode, world } from '#features/world/feature.ts'
import { Highlight } from '#figures/highlight.svelte.ts'
import { setsBothWheels } from '#figures/network/wheels.ts'
import type { Opened } from '#lab/opening.ts'
import type { PaneName } from '#lab/panes.ts'
import { LabSession } from '#lab/session.svelte.ts'
import { TimeMachine } from '#lab/time.svelte.ts'
import { LabUi } from '#lab/ui.svelte.ts'
import { loadPart } from '#parts/feature.ts'
import { saveProjectFile } from '#storage/handout.ts'
import { m } from '#words/message.ts'
import { againFrom, nextStep, taskOf } from './card.ts'
import * as navigation from './navigation.ts'
import { saidAtOnce, stoppingBlocks, wordsOf, wordsOfDifferences } from './findings.ts'
import { Layout } from './layout.svelte.ts'
import { RobotTools } from './robot-tools.svelte.ts'
import type { Blocks } from '#lab/blocks.ts'

/** Everything that the parts of the lab's screen share: they take it from the context, and no property relays it. */
export class LabScreenState {
  readonly session: LabSession
  readonly ui: LabUi
  readonly build: BuildMode
  readonly time: TimeMachine
  readonly robots: Robots
  readonly highlight: Highlight
  readonly tools = new RobotTools()
  readonly guide = new Guide()
  readonly handing = new HandingOut()
  readonly layout = new Layout(this)
  /** Does the program stand beside its blocks as Python, in the place of the network? */
  codeOpen = $state(false)
  /** That Python, once its part is there. */
  code = $state.raw<Code>()
  /** The block that is chosen. */
  chosen = $state<string | null>(null)
  /** What the blocks can be asked to do, once they are there. */
  blocks = $state.raw<Blocks>()
  /** Have they stood on the screen? */
  blocksStand = $state(false)
  /** The network that a hand holds. */
  held = $state<Held>(null)
  /** The playground for learning by trying, once a program learns so. */
  learner = $state.raw<Learner | null>(null)
  /** The classmate who edits it, too. */
  together = $state.raw<Together | null>(null)
  /** What may end the program here and not in Open Roberta; said once, when the file was opened. */
  differences = $state.raw<readonly Difference[]>([])

  constructor(opened: Opened) {
    this.session = new LabSession(opened)
    this.ui = new LabUi(this.session)
    this.build = new BuildMode(
      this.session,
      this.ui,
      async (failed) => (await loadPart(world, failed)).openWorkshop,
    )
    this.time = new TimeMachine(this.session)
    this.robots = new Robots(this.session)
    this.highlight = new Highlight(
      () => this.neurons,
      () => this.session.robotId,
    )
    // A card about learning by trying begins where Bo learns, where one part is seen at a time.
    if (this.card?.card.playground === 'q-learning') this.ui.page = 'network'
    if (this.card?.card.opens) void this.setWay(this.card.card.opens)
    this.session.settleBlocks = () => this.blocks?.settle() ?? true
    this.session.moveBlocks = (direction, program) => this.blocks?.moveBlocks(direction, program) ?? false
  }

  get card() {
    return this.session.opened.card
  }

  /** What the card's goal stands at: a flag, or nothing that has a name. */
  get goalPlace() {
    return this.card?.card.needs.includes('flag') ? 'flag' : ''
  }

  /** Name of the card or the project. What nobody has named is called like its card, in the language of now. */
  readonly title = $derived.by(() => {
    const { name } = this.session
    if (name !== (this.card?.card.id ?? 'free') && name !== 'free') return name
    return this.card ? textOf(this.card).title : m['session.free']()
  })

  /** The project under the name that is shown. */
  get named() {
    return { ...this.session.project, name: this.title }
  }

  /** The network on the screen. */
  readonly net = $derived.by(() => this.session.outlines[0] ?? null)
  readonly neurons = $derived.by(() => (this.net ? [...this.net.inputs, ...this.net.outputs] : []))
  /** Numbers of its last run; null for what does not run. */
  readonly trace = $derived.by(() =>
    this.net?.idle === null ? (this.session.lab.view.networks[this.net.id] ?? null) : null,
  )
  readonly weights = $derived.by(() => (this.net ? this.session.weights.shown(this.net.id) : {}))
  /** Is there a network that runs, to reset and step? */
  readonly hasNetwork = $derived.by(() => this.net?.idle === null)
  /** The pane whose step the step button takes: the one that was touched last. */
  readonly stepPane = $derived.by<PaneName>(() => {
    const { touched } = this.ui
    if (touched !== null && (touched !== 'network' || this.hasNetwork)) return touched
    return this.hasNetwork ? 'network' : 'program'
  })
  /** The network that is shown does not run: Start is not what comes next. */
  readonly loose = $derived.by(() => this.net !== null && this.net.idle !== null && this.held === null)
  /** The pane of the network was opened by hand, while there is no network. */
  emptyOpen = $state(false)
  /** Is the network looked at, in a program that tries as well? */
  netOpen = $state(false)
  /** Does the program learn by trying, on a map or with sensors? The third pane shows it. */
  readonly thirdIsLearned = $derived.by(() => this.session.learns || this.session.tries)
  /** In a project of one's own the pane is folded away until there is a network, or a hand opens it. */
  readonly folds = $derived.by(
    () => this.card === null && this.net === null && !this.thirdIsLearned && !this.layout.pages,
  )
  /** Is the pane the one of what the robot learns with its own sensors? A network beside it is looked at by hand. */
  readonly showsTried = $derived.by(() => this.session.tries && !(this.net !== null && this.netOpen))
  /** A card without a network has no pane for one. */
  readonly hasNetworkPane = $derived.by(() => {
    if (this.codeOpen || this.net !== null || this.thirdIsLearned) return true
    if (this.folds) return this.emptyOpen
    return !['drive', 'sorting'].includes(this.card?.card.playground ?? '')
  })
  /** What the tour would show; null: there is none. */
  readonly sight = $derived.by(() => sightOf(this.net, this.session.config))

  readonly #facts = $derived.by(() => this.session.lab.facts)
  get phase() {
    return this.#facts.phase
  }
  get running() {
    return this.phase === 'running'
  }
  get paused() {
    return this.phase === 'paused'
  }

  /** What is to be done, and which goals are reached. */
  readonly task = $derived.by(() =>
    taskOf(this.card, this.#facts.green.split(' '), this.ui.earned, this.learner?.learning.task.elsewhere),
  )
  /** All hints of the card, and how many the child has asked for; null where there are none. */
  readonly hints = $derived.by(() =>
    this.card ? { list: textOf(this.card).hints, shown: this.session.progress.hints } : null,
  )
  #hintOpener: HTMLElement | null = null
  toggleHint = (): void => {
    const { ui } = this
    if (ui.hintOpen) {
      ui.hintOpen = false
      return
    }
    this.#hintOpener = document.activeElement as HTMLElement | null
    void this.#askDue()
      .catch((cause: unknown) => console.warn('The hint that is due is not known.', cause))
      .then(() => (ui.hintOpen = true))
  }
  /** The miss that the newest hint has followed. */
  #answered: LabUi['missed'] = null
  /**
   * Asks for the first hint, after a further run that missed something for the next one, and for the one after those that were
   * followed. The last hint comes after a miss alone, and not before something was tried.
   */
  async #askDue(): Promise<void> {
    const { card, session } = this
    const { missed, tried } = this.ui
    const { shown = 0, list = [] } = this.hints ?? {}
    const ask = (count: number) => count > shown && session.askHint(count)
    if (shown === 0 || (missed !== null && missed !== this.#answered))
      ask(Math.min(shown + 1, list.length - (tried ? 0 : 1)))
    this.#answered = missed
    const { hintDue } = await import('@botgarten/content/hint-due')
    ask(Math.min(hintDue(card?.card.hintSteps, session.project) + 1, list.length - 1))
  }
  /** The focus goes back to where the hint was opened. */
  closeHint = (): void => {
    this.ui.hintOpen = false
    void tick().then(() => this.#hintOpener?.focus())
  }

  /** All goals are reached: what comes next. */
  readonly success = $derived.by(() => {
    const { card, ui, session } = this
    if (!card || !ui.success) return null
    const { starts } = session.progress
    return ui.success === 'counts' ? nextStep(card, starts) : againFrom(card, session.chosenStart, starts)
  })

  /** What is to be fixed now, one thing at a time. */
  readonly finding = $derived.by(() => this.ui.shown ?? this.session.findings.find(saidAtOnce) ?? null)
  /** Did the last run come to this and end there? Then the next one may start. */
  readonly #ended = $derived.by(() => {
    const { problem } = this.#facts
    return this.finding?.block === problem?.block && this.finding?.problem === problem?.problem
  })
  /** A block has to be fixed first: Start is off. */
  readonly blocked = $derived.by(() => (this.finding?.stops ?? false) && !this.#ended)
  /** Blocks that have to be fixed first. */
  readonly toMend = $derived.by(() => stoppingBlocks(this.session.findings))
  /** The finding in a child's words, or what was found in a file that was opened. */
  readonly said = $derived.by(() => {
    const { finding } = this
    if (finding)
      return wordsOf(
        finding,
        (fix) => this.blocks && applyFix(this.session, this.blocks, finding.block, fix),
        () => this.putIn(finding.block),
      )
    return this.differences.length > 0
      ? wordsOfDifferences(this.differences, (block) => this.blocks?.reveal(block, true))
      : null
  })
  /** What the real robot lacks stands at the blocks while their code is open. */
  readonly robotLacks = $derived.by(() => (this.codeOpen ? (this.code?.missing ?? []) : []))
  closeFinding(): void {
    if (this.finding) this.ui.show(null)
    else this.differences = []
  }

  /** What is said at the footer of the world: `help` leads to the program, `info` can be put away. */
  readonly notice = $derived.by(() => {
    const { notice } = this.ui
    if (this.finding?.stops)
      return {
        kind: 'help',
        text: this.#ended ? m['session.stoppedAt']() : m['session.needsHelp'](),
      } as const
    // A place that is passed is over: what happens after it is no mistake.
    if (notice === 'bumped' && this.success) return null
    if (notice === 'bumped' && !setsBothWheels(this.session.outlines, this.session.config))
      return { kind: 'info', text: m['world.bumped']() } as const
    return notice && ({ kind: 'info', text: m[`session.${notice}`]() } as const)
  })

  /** Brings a block into sight. */
  reveal(block: string, focus = false): void {
    this.blocks?.reveal(block, focus)
  }

  /** Puts what hangs loose where it is reached. */
  putIn(block: string): void {
    this.blocks?.putIn(block)
    this.ui.show(null)
  }

  resetWeights(): void {
    if (this.net) this.session.weights.reset(this.net.id)
  }

  /** What is seen inside the network comes with the first question. */
  inside = () => loadPart(inside)

  /** How the weights of the network come about: by turning its knobs, else from examples. */
  get way(): 'hand' | 'show' | 'practise' {
    return this.session.training?.way ?? 'hand'
  }
  setWay = async (way: 'hand' | 'show' | 'practise'): Promise<void> => {
    if (way !== 'hand') (await loadPart(training)).training(this.session, way)
    else if (this.session.training) this.session.training.way = null
  }

  openFile = (file: File): Promise<void> => navigation.openFile(file, this.ui)
  saveFile = (): void => saveProjectFile(this.named)
}

export const [takeScreen, giveScreen] = createContext<LabScreenState>()
