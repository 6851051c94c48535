import type { SaveStatus } from '#storage/autosave.ts'
import type { Snippet } from 'svelte'
import type { Phase } from '@botgarten/lab'
import type { Project } from '@botgarten/programs'
import type { Markdown } from '#parts/markdown.ts'
import type { Crew } from '#features/crew/robots.svelte.ts'
import type { TimeMachine } from '#lab/time.svelte.ts'
import type { CardFace } from '#figures/card/face.ts'
import type { SortingDoor } from '#features/sorting/later.ts'

/** A pane of the lab. */
export type PaneName = 'program' | 'world' | 'network'

/** What a pane's body is told. `visible` false: it is not on the screen (draw nothing); `compact`: the small world above the network on a phone. */
interface PaneState {
  readonly visible: boolean
  readonly compact: boolean
}

/** `elsewhere`: another tab holds this project; `failed` offers to try again. */

export interface Goal {
  readonly id: string
  /** A word or two: "comes near". */
  readonly label: string
  readonly passed: boolean
}

export interface Task {
  readonly title: string
  /** The goal in one sentence. */
  readonly sentence: string
  /** Empty in the free lab: the strip is one line then. */
  readonly goals: readonly Goal[]
}

/** Start poses, counted from 0. */
export interface Starts {
  readonly count: number
  readonly chosen: number
  readonly passed: readonly number[]
}

/** All hints of the card, and how many the child has asked for so far. */
export interface Hints {
  readonly list: readonly Markdown[]
  readonly shown: number
}

/** Something to mend, in a child's words. The first fix is the main button. */
export interface FindingWords {
  readonly title: string
  readonly text?: string
  readonly fixes: readonly { readonly label: string; readonly mend: () => void }[]
}

/** A line at the foot of the world. `help` points to the program ("A block needs help"), `info` can be put away. */
export interface WorldNotice {
  readonly kind: 'help' | 'info'
  readonly text: string
}

/** All goals are green: what comes next. `start`: index of a pose not yet passed · `again`: that did not count, it is tried from this pose. */
export type NextStep =
  | { readonly kind: 'start'; readonly index: number }
  | { readonly kind: 'again'; readonly index: number | null }
  | { readonly kind: 'card'; readonly href: string; readonly name: string }
  | { readonly kind: 'none' }

/** What of the robot can be opened from the world's menu. */
interface RobotMenu {
  readonly senses: boolean
  readonly panel: boolean
  readonly field: boolean
  show(tool: 'build' | 'senses' | 'panel' | 'field', open: boolean): void
}

/** What the gear of the world switches. */
interface WorldSettings {
  readonly rays: boolean
  readonly trail: boolean
}

/** Where a child has dragged the pane borders, as shares 0..1 of the lab, for each arrangement of panes. */
export interface PaneSizes {
  readonly columns?: readonly [program: number, world: number]
  readonly stacked?: readonly [program: number, world: number]
  readonly rows?: readonly [world: number, upper: number]
}

/**
 * Everything the lab's frame shows and everything a child can ask of it. The frame keeps only what is about itself:
 * which pane fills the screen, which tab is open on a phone, which dialog or panel is open.
 */
export interface LabFrameProps {
  // ---- bodies ----
  program: Snippet<[PaneState]>
  world: Snippet<[PaneState]>
  network: Snippet<[PaneState]>
  /** Further tools in a pane's head, before the fill button. */
  worldTools?: Snippet
  networkTools?: Snippet
  /** Lies over the foot of the program, or above the one part of the lab that is seen (`alone`), which it can turn to another. */
  tour?: Snippet<[turn: (pane: PaneName) => void, alone: boolean]>

  // ---- top bar ----
  /** Name of the card or the project. */
  title: string
  saved: SaveStatus['state']
  onretrysave: () => void
  /** null in the free lab: no Card button. */
  card: CardFace | null
  onopenfile: (file: File) => void
  onsavefile: () => void
  onsaveopenroberta: () => void
  /** The project as a link would carry it. */
  onshare: () => Project
  /** Ways into the sorting playground, as far as there are any now. */
  sorting: () => Promise<readonly SortingDoor[]>
  /** Shows the tour again; not given where there is none. */
  ontour?: (() => void) | undefined
  settings: WorldSettings
  onsettings: (settings: WorldSettings) => void
  robot: RobotMenu

  // ---- task strip ----
  task: Task
  /** null where there are none: no Hint button. */
  hints: Hints | null
  /** The child asks for one more hint; `shown` is how many are seen then. */
  onhint: (shown: number) => void
  /** Set when all goals have turned green, null otherwise. Bo cheers once each time it is set to what counts. */
  success: NextStep | null
  /** The next step was taken (`start`) or put away. */
  onsuccessclose: () => void

  // ---- program ----
  canUndo: boolean
  canRedo: boolean
  onundo: () => void
  onredo: () => void
  /** One thing at a time, or null. */
  finding: FindingWords | null
  onfindingclose: () => void

  // ---- running (running.md 10: one clock, two bars) ----
  phase: Phase
  /** A block has to be mended first: Start is off. */
  blocked: boolean
  /** The network that is shown does not run: Start is not what comes next. */
  loose: boolean
  onstart: () => void
  onstop: () => void
  onpause: () => void
  onresume: () => void
  /** World: one tick · program: next block · network: next run of the net. */
  onstep: (kind: 'tick' | 'block' | 'network') => void
  onresetworld: () => void
  onresetweights: () => void
  /** Is there a network that runs, to reset and step? */
  hasNetwork: boolean
  /** The program learns by trying: that has the place of the network. */
  learns: boolean
  /** A card without a network has no pane for one. */
  networkPane: boolean
  /** The child builds the world, which needs room. */
  building: boolean
  /** Both given: a sound switch stands beside Start (running.md 12). */
  sound?: boolean
  onsound?: (on: boolean) => void

  /** Back and forth in the run, and how fast it goes (running.md 9, 10). */
  time: TimeMachine

  // ---- world ----
  crew: Crew
  /** null: no chooser. */
  starts: Starts | null
  onchoosestart: (index: number) => void
  notice: WorldNotice | null
  onnoticeclose: () => void
  /** Brings the block that the notice speaks of into sight. */
  onshowblock: () => void

  // ---- what can go wrong ----
  /** Another tab has saved this project meanwhile. */
  conflict: boolean
  onkeepcopy: () => void
  onloadnewer: () => void
  /** Another tab has thrown this project away meanwhile. */
  gone: boolean
  onkeepgone: () => void
  /** Why nothing can be saved. The panel says what to try, and offers to save a file. */
  storage: SaveStatus['storage']
  /** What is too much to be saved, and where. */
  refusal: SaveStatus['refusal']
  /** Brings a block into sight. */
  onreveal: (block: string) => void
  /** A plain message with one OK: a broken project file, for instance. */
  message: {
    readonly title: string
    readonly text: string
    readonly onsaveraw?: (() => void) | undefined
  } | null
  onmessageclose: () => void

  // ---- pane borders ----
  sizes?: PaneSizes
  /** A border was dragged: keep it where you like. */
  onsizes?: (sizes: PaneSizes) => void
}
