import type { Selectable } from 'kysely'

/** Two pupils on one program. */
export interface PairTable {
  id: string
  class: string
  inviter: string
  invited: string
  /** Name of the project. */
  title: string
  accepted: 0 | 1
  /** The pupil who has left: the other one may still read what was done. */
  left: string | null
  /** The pupil whose turn it is to be the hand; the other is the eye. */
  hand: string
  /** How many entries there are, and how many bytes their operations have. */
  length: number
  bytes: number
  /** The own count of the last entry of each. */
  ofInviter: number
  ofInvited: number
  /** Entries within one window of time. */
  /** Of the steady clock, ms. */
  windowEndsAt: number
  inWindow: number
  at: number
  /** The project that they began with. */
  document: string
}

/** What one of the two has done; `seq`: its place in the common order, from 0. */
export interface PairEntryTable {
  pair: string
  seq: number
  author: 'a' | 'b'
  n: number
  base: number
  /** JSON */
  op: string
}

export type PairRow = Omit<Selectable<PairTable>, 'document'>
