import type { Block, Finding, Frame, NeuronLook, Value } from '@botgarten/blocks'
import type { Brain } from '@botgarten/learning/neural-network'
import type { World } from '@botgarten/simulation'

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
  /** Blocks of this tick's budget that are used up. */
  spent: number
  /** Seconds of the tick that is over for this thread; running it again in that tick does nothing. */
  overAt: number
  ended: boolean
  problem: (Finding & { readonly stops: true }) | null
}

/** A network block and its neurons, read from the blocks. */
export interface NetworkOutline {
  readonly id: string
  readonly inputs: readonly NeuronOutline[]
  readonly outputs: readonly NeuronOutline[]
}

export interface NeuronOutline {
  readonly id: string
  readonly type: string
  readonly fields: { readonly [name: string]: string }
  readonly look: NeuronLook
}

/** What a child has reached with a card. */
export interface Progress {
  /** Start poses from which every check has passed, by their index. */
  readonly starts: readonly number[]
  readonly hints: number
}

/** What a child keeps: one file, at most 5 MB. */
export interface Project {
  readonly botgarten: 1
  readonly name: string
  readonly card?: string
  readonly programs: { readonly [id: string]: Program }
  readonly world: World
  /** By the id of the network block. */
  readonly brains: { readonly [networkId: string]: Brain }
  readonly assets: { readonly [sha256: string]: { readonly type: 'image/png'; readonly base64: string } }
  readonly progress?: Progress
}

export type { Value }
