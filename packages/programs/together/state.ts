import type { Block } from '@botgarten/blocks'
import type { Author, Json, Place, Shared } from './types.ts'

/** What was deleted, in case the other one was about to change it. */
export interface Grave {
  readonly block: Block
  readonly place: Place
  /** When it was deleted: the entry's place in the common order. */
  readonly at: number
  readonly by: Author
}

/** A network or a thing that was deleted. */
interface Lost {
  readonly value: Json
  readonly at: number
  readonly by: Author
}

/** Entries by their place in the common order. */
type Touched = { readonly [Who in Author]?: number }

/** The common program, and as much of its past as later entries need. */
export interface State {
  doc: Shared
  /** Who has edited a block (`program/id`), a network or a thing last, and when. */
  readonly touched: Map<string, Touched>
  readonly graves: Map<string, Grave>
  readonly lost: Map<string, Lost>
}

export const beginning = ({ programs, brains, world }: Shared): State => ({
  doc: { programs, brains, world },
  touched: new Map(),
  graves: new Map(),
  lost: new Map(),
})

export const copyOf = ({ doc, touched, graves, lost }: State): State => ({
  doc,
  touched: new Map(touched),
  graves: new Map(graves),
  lost: new Map(lost),
})
