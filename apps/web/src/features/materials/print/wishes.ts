import type { Turn } from './imposition.ts'

/** How something is to be printed. */
export interface Wishes {
  /** What cards are printed on: two beside each other on A4, or one on A5. */
  readonly paper: 'a4' | 'a5'
  readonly turn: Turn
  /** Where codes lead, with a slash at its end; null: no code is printed. */
  readonly address: string | null
}

/** Reads `?paper=a4|a5&turn=short|long&address=…`; an empty address: none. What is not said is as `here` has it. */
export function wishesIn(search: Pick<URLSearchParams, 'get'>, here: string): Wishes {
  return {
    paper: search.get('paper') === 'a5' ? 'a5' : 'a4',
    turn: search.get('turn') === 'long' ? 'long' : 'short',
    address: addressIn(search.get('address'), here),
  }
}

function addressIn(asked: string | null, here: string): string | null {
  if (asked === '') return null
  const url = URL.parse(asked ?? here)
  if (url === null || !/^https?:$/.test(url.protocol)) return null
  return url.href.endsWith('/') ? url.href : `${url.href}/`
}
