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
  readonly raw?: { readonly attributes: { readonly [name: string]: string } }
}

/** A running program. Whole state, plain data; a structured copy of it goes on the same. */
export interface Thread {
  frames: Frame[]
  /** Last block that was started, for the light on the screen. */
  lit: string | null
  /** Blocks since the last back edge sensed, drove, showed, sounded or ran a net. */
  acted: boolean
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
