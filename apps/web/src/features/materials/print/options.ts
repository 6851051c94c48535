import { parseUrl } from '@botgarten/browsers'

/** Over which edge of the paper a printer turns it for the other side. */
export type Turn = 'short' | 'long'

/** What stands left and right on a page of A4 on its side: the number of a side of a card, null: nothing. */
export type CardPage = readonly [number | null, number | null]

/**
 * Two cards a sheet of A4: sides are front, back, front, back …; pages are the front and the back of a sheet, again and
 * again. Turned over the short edge left becomes right, so the backs change places; over the long edge they stay.
 * Where cards are odd in number the last one is printed twice. What has one side alone needs no other page.
 */
export function twoUp(sides: number, turn: Turn): readonly CardPage[] {
  const cards = Math.ceil(sides / 2)
  const sheets = Array.from({ length: Math.ceil(cards / 2) }, (_, sheet) => [
    2 * sheet,
    Math.min(2 * sheet + 1, cards - 1),
  ])
  const back = (card: number) => (2 * card + 1 < sides ? 2 * card + 1 : null)
  return sheets.flatMap(([left, right]): CardPage[] => {
    const [a, b] = [left!, right!]
    const front: CardPage = [2 * a, 2 * b]
    if (sides === 1) return [front]
    return [front, turn === 'short' ? [back(b), back(a)] : [back(a), back(b)]]
  })
}

/** How something is to be printed. */
export interface PrintOptions {
  /** What cards are printed on: two beside each other on A4, or one on A5. */
  readonly paper: 'a4' | 'a5'
  readonly turn: Turn
  /** Where codes lead, with a slash at its end; null: no code is printed. */
  readonly address: string | null
  /** For a printer without colours: outlines without fills. */
  readonly grey: boolean
}

/** Reads `?paper=a4|a5&turn=short|long&grey=yes&address=…`; an empty address: none. What is not said is as `here` has it. */
export function optionsIn(search: Pick<URLSearchParams, 'get'>, here: string): PrintOptions {
  return {
    paper: search.get('paper') === 'a5' ? 'a5' : 'a4',
    turn: search.get('turn') === 'long' ? 'long' : 'short',
    address: addressIn(search.get('address'), here),
    grey: search.get('grey') === 'yes',
  }
}

function addressIn(asked: string | null, here: string): string | null {
  if (asked === '') return null
  const url = parseUrl(asked ?? here)
  if (url === null || !/^https?:$/.test(url.protocol)) return null
  return url.href.endsWith('/') ? url.href : `${url.href}/`
}
