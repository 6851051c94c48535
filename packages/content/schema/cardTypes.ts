import type { Check } from '@botgarten/lab'
import type { Weights } from '@botgarten/learning/neural-network/brain'
import type { Project } from '@botgarten/programs'
import type { Pose, World } from '@botgarten/simulation'

/** `card.json` of a card's folder. */
export interface Card {
  readonly id: string
  /** Printed on the card: way of learning and number, "NN 5"; a number alone on the first cards. */
  readonly code: string
  readonly playground: Playground
  /** Cards that lie together in their bed, under a word of their own. */
  readonly group?: Group
  /** Which part of its bed it lies in; absent: the first, by hand. */
  readonly chapter?: Chapter
  /** Tab of the network that is open at first; absent: the knobs. */
  readonly opens?: 'show' | 'practise'
  /** Youngest and oldest grade. */
  readonly grades: readonly [number, number]
  readonly minutes: number
  /** Start poses from each of which the solution holds. */
  readonly starts: readonly Pose[]
  /** What is laid out under "You need". */
  readonly needs: readonly Need[]
  /** Folder under `content/worlds`. */
  readonly world: string
  readonly checks: readonly Check[]
  /** Id of the card that comes next. */
  readonly next: string | null
  /** By hint: the measures of the program that show that it was followed; null, or nothing at the end: only a run shows it. */
  readonly hintSteps?: readonly (HintStep | null)[]
  /** Where the last card of a bed leads. */
  readonly place?: 'zoo'
  /** The network that "Put a network in" makes; absent: one of two distances and two motors, at the end of the loop. */
  readonly network?: CardNetwork
  /** The same blocks with the weights of another card, as a second robot beside the first. */
  readonly beside?: Beside
}

/**
 * The least values of some measures of a program: `knobs`, weights that are not 0; `examples`, rows of the table; `rounds` of
 * practice; `#id`, the number in the first field of this block; `3-2`, blocks that close the road from 3 to 2; any other name counts blocks whose type begins with it.
 */
export interface HintStep {
  readonly [measure: string]: number
}

/** The neurons of a network in the order of its layers, and the id of the block below which it is put. */
export interface CardNetwork {
  readonly inputs: readonly CardNeuron[]
  readonly outputs: readonly CardNeuron[]
  readonly below?: string
}

/** The block of a neuron. */
export interface CardNeuron {
  readonly type: string
  readonly fields: { readonly [name: string]: string }
}

/** Weights that solve another card with the same blocks, and where its robot starts. */
export interface Beside {
  readonly card: string
  readonly pose: Pose
  /** By the id of the network's block. */
  readonly weights: { readonly [network: string]: Weights }
}

/** What stands beside the world; `drive` and `sorting`: blocks alone. */
export type Playground = 'network' | 'drive' | 'q-learning' | 'sorting'

/** `repair`: brains that are wrong on purpose. */
export type Group = 'repair'

/** `examples`: a network learns from rows that a child showed; `trying`: from what pays. */
export type Chapter = 'examples' | 'trying'

export type Need =
  | 'distanceSensors'
  | 'colourSensor'
  | 'motors'
  | 'lamp'
  | 'blueSquare'
  | 'wall'
  | 'flag'
  | 'speaker'
  | 'display'

/** Programs and brains of a start, a solution or a typical wrong answer. */
export type CardProgram = Pick<Project, 'programs' | 'brains' | 'tables' | 'raced'>

/** A world as content: what every robot of it starts from is said by the card. */
export type WorldFile = World

/** The part of Markdown that a card may hold, as a syntax tree (shapes of mdast); nothing else passes the reader. */
export type MarkdownNode =
  | { readonly type: 'text'; readonly value: string }
  | {
      readonly type: 'paragraph' | 'strong' | 'emphasis' | 'listItem'
      readonly children: readonly MarkdownNode[]
    }
  | { readonly type: 'list'; readonly ordered: boolean; readonly children: readonly MarkdownNode[] }

export type Markdown = readonly MarkdownNode[]

type FreeNode =
  | { readonly type: 'text'; readonly value: string }
  | {
      readonly type: 'paragraph' | 'strong' | 'emphasis' | 'listItem' | 'heading'
      readonly children: FreeText
    }
  | { readonly type: 'list'; readonly ordered: boolean; readonly children: FreeText }
  | { readonly type: 'link'; readonly href: string; readonly children: FreeText }

/** Markdown that somebody writes who runs a lab: headings and links besides what a card may hold. */
export type FreeText = readonly FreeNode[]

/** A card in one language. */
export interface CardText {
  readonly title: string
  readonly story: Markdown
  /** A short call in bold, then the goal in one sentence. */
  readonly goal: { readonly call: string; readonly sentence: string }
  /** What is to be seen, by the id of the check. */
  readonly checks: { readonly [checkId: string]: string }
  readonly hints: readonly Markdown[]
  readonly further: Markdown
}
