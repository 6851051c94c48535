import type { Block } from '@botgarten/blocks'
import type { Program, Project } from '../types.ts'

// Two edit one program: what they do to it is data, and the server puts it in one order for both.

/** As much of a project as two share. */
export type Shared = Pick<Project, 'programs' | 'brains' | 'world'>

/** One of the two: `a` has invited `b`. */
export type Author = 'a' | 'b'

/**
 * Where a block is put. Blocks are named by their ids, so that a place stays what it is whatever happens around it.
 * `x`, `y`: alone on the workspace; for the first block of a stack: its whole stack goes there.
 */
export type Place =
  | { readonly x: number; readonly y: number }
  | { readonly after: string }
  | { readonly before: string }
  /** The first in a row within a block. */
  | { readonly in: string; readonly statement: string }
  | { readonly in: string; readonly value: string }

/** What a block is beside its fields and what hangs in it. */
export const parts = [
  'mutation',
  'comment',
  'data',
  'hide',
  'disabled',
  'collapsed',
  'inline',
  'shadow',
  'flags',
] as const satisfies readonly (keyof Block)[]
export type PartName = (typeof parts)[number]

export type Json = unknown

/** An edit. Every one can be applied to every program: what makes no sense there changes nothing. */
export type Operation =
  /** A block, with what hangs in it. */
  | { readonly kind: 'add'; readonly program: string; readonly block: Block; readonly place: Place }
  /** A block alone, with what hangs in it; what follows it stays. */
  | { readonly kind: 'move'; readonly program: string; readonly block: string; readonly place: Place }
  | { readonly kind: 'delete'; readonly program: string; readonly block: string }
  | {
      readonly kind: 'field'
      readonly program: string
      readonly block: string
      readonly name: string
      readonly value: string | null
    }
  | {
      readonly kind: 'part'
      readonly program: string
      readonly block: string
      readonly name: PartName
      readonly value: Json
    }
  /** A part of a network by its path from `brains`, or of the world; in lists the next name is an id. null: it goes. */
  | Setting
  /** A program comes or goes with its robot. */
  | { readonly kind: 'program'; readonly program: string; readonly value: Program | null }

interface Set<Kind> {
  readonly kind: Kind
  readonly path: readonly string[]
  readonly value: Json
}
export type Setting = Set<'knob'> | Set<'thing'>

/** An operation of one of the two. */
export interface Entry {
  readonly by: Author
  /** The author's own count, from 1: sent twice it is one. */
  readonly n: number
  /** How many entries of the common order the author had seen. */
  readonly base: number
  readonly op: Operation
}
