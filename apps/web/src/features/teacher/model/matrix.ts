import type { CardHead } from '@botgarten/content/catalogue'
import type { Results } from './answers.ts'

/** How far a pupil is with a card: from so many of its start places it was solved. `closed`: it is not free today. */
export type Cell =
  | { readonly kind: 'done' | 'notYet' | 'closed' }
  | { readonly kind: 'working'; readonly passed: number; readonly of: number }

export type MatrixCard = Pick<CardHead, 'id' | 'bed' | 'starts'>

export interface MatrixRow {
  readonly id: string
  readonly nickname: string
  readonly cells: readonly Cell[]
  /** How many cards are done. */
  readonly done: number
}

function cellOf(
  { id, starts }: MatrixCard,
  { done }: Results['pupils'][number],
  free: ReadonlySet<string> | null,
): Cell {
  const passed = Object.hasOwn(done, id) ? done[id]! : null
  if (passed !== null && starts > 0 && passed >= starts) return { kind: 'done' }
  if (passed !== null) return { kind: 'working', passed, of: starts }
  return { kind: free && !free.has(id) ? 'closed' : 'notYet' }
}

const isDone = ({ kind }: Cell) => kind === 'done'

/** Pupils × cards, from A to Z. Cards that are not free today are marked where nothing was begun. */
export function matrixOf(cards: readonly MatrixCard[], { pupils, free }: Results): readonly MatrixRow[] {
  const open = free && new Set(free)
  return pupils
    .map((pupil) => {
      const cells = cards.map((card) => cellOf(card, pupil, open))
      return { id: pupil.id, nickname: pupil.nickname, cells, done: cells.filter(isDone).length }
    })
    .sort((a, b) => a.nickname.localeCompare(b.nickname))
}

/** By how many pupils each card is done. */
export const doneBy = (rows: readonly MatrixRow[], cards: readonly MatrixCard[]): readonly number[] =>
  cards.map((_card, at) => rows.filter(({ cells }) => isDone(cells[at]!)).length)
