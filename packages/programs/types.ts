import type {
  Assertion,
  Block,
  Finding,
  Frame,
  Letter,
  NetMemory,
  NeuronLook,
  SortingMemory,
  Value,
} from '@botgarten/blocks'
import type { Activation, Brain } from '@botgarten/learning/neural-network/brain'
import type { Settings } from '@botgarten/learning/q-learning'
import type { TableBrain } from '@botgarten/learning/q-senses'
import type { StreamState } from '@botgarten/numbers'
import type { World } from '@botgarten/simulation'
import type { LaneKind } from './lanes.ts'
import type { MapDocument } from './map-document.ts'
import type { OwnCard } from './own-card.ts'
import type { SortingDocument } from './sorting/document.ts'

export interface Stack {
  readonly x: number
  readonly y: number
  readonly blocks: readonly Block[]
}

/** A program as frozen data. `config` holds the robot configuration's blocks of Open Roberta files. */
export interface Program {
  readonly stacks: readonly Stack[]
  readonly config: { readonly stacks: readonly Stack[] }
  /** What an Open Roberta file says at its root and of its two parts. */
  readonly raw?: {
    readonly attributes: Attributes
    readonly config?: Attributes
    readonly root?: Attributes
  }
}

interface Attributes {
  readonly [name: string]: string
}

/** A running program. Whole state, plain data; a structured copy of it goes on the same. */
export interface Thread {
  frames: Frame[]
  /** Statement block that was begun last, for the light on the screen. */
  lit: string | null
  /** How many statement blocks have been begun so far, for stepping from block to block. */
  started: number
  /** How many blocks so far have sensed, driven, shown, sounded or run a net (running.md 3). */
  acts: number
  /** Conditions asked, runs of a net and looks into a table so far. */
  decisions: number
  /** Blocks of this tick's budget that are used up. */
  spent: number
  /** Seconds of the tick that is over for this thread; running it again in that tick does nothing. */
  overAt: number
  ended: boolean
  /** Variables by name: first those of the program, then of each function that is being executed. */
  scopes: Scope[]
  /** The stream of the program's random numbers. */
  random: StreamState
  /** What blocks of the `robActions_NNstep` family have done. */
  net: NetMemory
  /** Letters of other robots that nobody has read yet. */
  letters: Letter[]
  assertions: Assertions
  /** What `robActions_debug` said last, newest at the end. */
  notes: { readonly block: string; readonly text: string }[]
  /** What its blocks of sorting have collected and found. */
  sorting: SortingMemory
  problem: (Finding & { readonly stops: true }) | null
}

export interface Scope {
  [variable: string]: Value
}

/** What blocks `robActions_assert` found out. Of those that failed the first hundred are kept. */
export interface Assertions {
  passed: number
  /** How many did not hold. */
  wrong: number
  failed: Assertion[]
}

/** A network block and its neurons, read from the blocks. */
export interface NetworkOutline {
  readonly id: string
  readonly inputs: readonly NeuronOutline[]
  /** From the inputs to the outputs. */
  readonly hidden: readonly HiddenOutline[]
  readonly outputs: readonly NeuronOutline[]
}

/**
 * A network and what keeps it from running. `loose`: it hangs under no start block, or in a function that nobody calls ·
 * `behind`: a loop before it never ends · `off`: it, or what it stands in, is switched off · null: it runs.
 */
export interface NetworkInUse extends NetworkOutline {
  readonly idle: 'loose' | 'behind' | 'off' | null
}

/** A hidden layer: the id of its block, how many neurons, and what becomes of their sums. */
export interface HiddenOutline {
  readonly id: string
  readonly neurons: number
  readonly activation: Activation
}

export interface NeuronOutline {
  readonly id: string
  readonly type: string
  readonly fields: { readonly [name: string]: string }
  readonly look: NeuronLook
}

/** What a program wants to be learned by trying, read from the blocks. */
export interface LearningOutline {
  /** Ids of the blocks that say so. */
  readonly blocks: {
    readonly map: string
    readonly behaviour?: string
    readonly experience?: string
    readonly draw?: string
    readonly drive?: string
  }
  /** Folder under `content/maps`, or `own:<id>` for a map of the project. */
  readonly map: string
  readonly start: number
  readonly goal: number
  /** Each in one direction. */
  readonly closed: readonly (readonly [from: number, to: number])[]
  readonly settings: Settings
  /** What moves pay and cost beside the goal's reward; not there: nothing. */
  readonly pay?: Pay
  /** It stops after so many episodes or so many moves. */
  readonly episodes: number
  readonly moves: number
}

/** Rewards of a child's own. */
export interface Pay {
  /** Every move costs its length. */
  readonly length?: true
  /** Every move costs so much. */
  readonly step?: number
  /** By station (`3`) or by road in one direction (`2-5`): paid on arrival, or on the way. */
  readonly own?: { readonly [place: string]: number }
}

/** How far a learning has come. It is a whole by its blocks, its seed and its moves: the same every time (running.md 2). */
export interface Learned {
  readonly seed: number
  readonly moves: number
  /** Of the settings that it was learned with, as `learningKey` writes them. */
  readonly key: string
  /** Does this run stand in the table already? */
  readonly noted: boolean
  /** Rows of the table of experiments, the oldest first. */
  readonly runs: readonly LearnedRun[]
}

export interface LearnedRun {
  readonly map: string
  readonly start: number
  readonly goal: number
  readonly closed: string
  readonly alpha: number
  readonly gamma: number
  readonly nu: number
  readonly rho: number
  readonly rules: string
  readonly seed: number
  readonly episodes: number
  readonly moves: number
  readonly limitEpisodes: number
  readonly limitMoves: number
  /** The way that was learned, `3-5-0-1`; '' where there is none. */
  readonly way: string
  /** Sections of the shortest way there is; 0: none. */
  readonly shortest: number
  /** Episode in which the way was found that stayed; 0: none. */
  readonly found: number
  /** What the child guessed before. */
  readonly guess: string
  /** Own rewards, as `payText` writes them. */
  readonly pay?: string
}

/** What a child has reached with a card. */
export interface Progress {
  /** Start poses from which every check has passed, by their index. */
  readonly starts: readonly number[]
  readonly hints: number
}

/** What came of a project's last race of brains. */
export interface Raced {
  readonly course: string
  /** How many drove to the end. */
  readonly brains: number
  /** Which one its child would trust, and which one it could explain: every answer is right. */
  readonly trust?: LaneKind
  readonly explain?: LaneKind
}

/** What has gone into a project so far, counted by the lab, never typed. */
export interface Effort {
  /** Moves of knobs; a pull is one. */
  readonly knobs: number
  /** Runs that were begun. */
  readonly starts: number
  /** How often its first robot began to touch something, in runs and under a hand. */
  readonly bumps: number
  /** Seconds with a hand on it; pauses of over 30 s do not count. */
  readonly hand: number
  /** Seconds in which the computer practised or tried. */
  readonly computer: number
}

/** What a child keeps: one file, at most 5 MB. */
export interface Project {
  readonly botgarten: 1 | 2 | 3 | 4 | 5
  readonly name: string
  readonly card?: string
  /** It belongs to this playground, and is opened there: its program and its world are empty ones. */
  readonly playground?: 'sorting'
  readonly programs: { readonly [id: string]: Program }
  readonly world: World
  /** By the id of the network block. */
  readonly brains: { readonly [networkId: string]: Brain }
  /** By the id of the block that learned it by trying with the robot's sensors. A file has them among its `brains`. */
  readonly tables?: { readonly [blockId: string]: TableBrain }
  /** Maps of its own. Blocks call one `own:<id>`. */
  readonly maps?: { readonly [id: string]: MapDocument }
  /** A card that somebody has made of it, or that a child plays. It is in place of `card`. */
  readonly ownCard?: OwnCard
  /** By program: what its robot has learned by trying. */
  readonly q?: { readonly [program: string]: Learned }
  /** The sorting playground as it was left. It is not checked here: the playground that opens it validates it. */
  readonly sorting?: SortingDocument | { readonly [part: string]: unknown }
  readonly assets: { readonly [sha256: string]: { readonly type: 'image/png'; readonly base64: string } }
  readonly progress?: Progress
  readonly effort?: Effort
  readonly raced?: Raced
  /** The toolbox that its child has chosen. */
  readonly shelf?: 'plain' | 'all'
  /** What it was made from in the gallery of a class, the oldest first. No names: they stay in the class. */
  readonly madeFrom?: readonly { readonly id: string; readonly title: string }[]
}

export type { Value }
