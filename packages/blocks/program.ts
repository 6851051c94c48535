import type { LedColour, MotorPort } from '@botgarten/simulation'

/** One block. Rows are flat, as in Open Roberta: what follows a block stands after it in the same list. */
export interface Block {
  readonly id: string
  readonly type: string
  readonly fields?: { readonly [name: string]: string }
  readonly mutation?: Mutation
  readonly values?: { readonly [name: string]: Block }
  readonly statements?: { readonly [name: string]: readonly Block[] }
  readonly comment?: string
  readonly data?: string
  readonly hide?: readonly string[]
  readonly disabled?: boolean
  readonly collapsed?: boolean
  readonly inline?: boolean
  readonly shadow?: boolean
  readonly flags?: { readonly [name: string]: string }
}

export interface Mutation {
  readonly attrs: { readonly [name: string]: string }
  readonly args?: readonly { readonly name: string; readonly type: string }[]
}

/** A block as it comes from the toolbox: without an id, with what is plugged in. */
export type Template = Omit<Block, 'id' | 'values' | 'statements'> & {
  readonly values?: { readonly [name: string]: Template }
  readonly statements?: { readonly [name: string]: readonly Template[] }
}

/** Colours are `#RRGGBB` in upper case. */
export type Value = number | string | boolean | null | Order | readonly Value[]

/** What an output neuron wants done with its value. The network block carries the orders out together. */
export type Order =
  | { readonly order: 'motor'; readonly port: MotorPort; readonly level: number }
  | { readonly order: 'led'; readonly colour: LedColour; readonly level: number }
  | { readonly order: 'text'; readonly text: string; readonly level: number }
  | { readonly order: 'sound'; readonly level: number }

/** Types of Open Roberta's blocks as its files name them; of the network's parts ours. */
export type ValueType =
  | PlainType
  | ListType
  | 'InputNode'
  | 'OutputNode'
  | 'InputLayer'
  | 'OutputLayer'
  /** A road that is closed, and a list of them. */
  | 'Obstacle'
  | 'ObstacleList'
export type PlainType = 'Number' | 'String' | 'Boolean' | 'Colour' | 'Connection'
export type ListType = `Array_${PlainType}`
