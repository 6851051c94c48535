import { resolve } from 'node:path'
import { CallError, options } from '../errors.ts'
import { oneOf } from '../learn-options.ts'
import { itemsNamed, type FoundItem } from './items.ts'

const known = {
  lang: { type: 'string' },
  paper: { type: 'string' },
  turn: { type: 'string' },
  out: { type: 'string' },
  address: { type: 'string' },
  json: { type: 'boolean' },
  help: { type: 'boolean' },
} as const

const languages = ['de', 'en'] as const
type Language = (typeof languages)[number]

/** What a call asks to be printed, and how. */
export interface Order {
  readonly items: readonly FoundItem[]
  readonly languages: readonly Language[]
  /** What cards are printed on: one on A5, or two beside each other on A4. */
  readonly paper: 'a4' | 'a5'
  /** The edge over which two-sided A4 is turned. */
  readonly turn: 'short' | 'long'
  readonly out: string
  /** Where the codes lead; null: none is printed. */
  readonly address: string | null
  readonly json: boolean
}

export const help = `botgarten print ITEM…|all [options]: materials as PDF

  --lang de|en       a language; both where none is named
  --paper a4|a5      cards: two beside each other on A4 with marks to cut (that is what comes where nothing
                     is said), or one on A5. Sheets are A4 and slides 16:9 on either.
  --turn short|long  cards on A4, printed on both sides: over which edge your printer turns the paper (short
                     where nothing is said)
  --out DIR          the folder for the files (here where none is named); it is made where it is missing
  --address URL      where your lab lives: codes lead there, and the address stands beside them. Without it no
                     code is printed, only the number of the card.
  --json             what was written, as JSON`

/** Reads the call; null where it asks for help. @throws CallError */
export function orderOf(args: string[]): Order | null {
  const { values, positionals } = options(args, known)
  if (values.help) return null
  if (positionals.length === 0) throw new CallError('"print" takes an item or "all": botgarten print --help')
  return {
    items: itemsNamed(positionals),
    languages: values.lang === undefined ? languages : [oneOf('lang', values.lang, languages)],
    paper: oneOf('paper', values.paper, ['a4', 'a5'] as const),
    turn: oneOf('turn', values.turn, ['short', 'long'] as const),
    out: resolve(values.out ?? '.'),
    address: values.address === undefined ? null : addressOf(values.address),
    json: values.json ?? false,
  }
}

function addressOf(text: string): string {
  const url = URL.parse(text)
  if (url === null || !/^https?:$/.test(url.protocol))
    throw new CallError(`--address takes an address such as https://botgarten.example.org, not "${text}".`)
  return url.href
}
