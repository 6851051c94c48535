import { resolve } from 'node:path'
import { CallError } from '../errors.ts'
import { oneOf, options } from '../options.ts'
import { languages, type Language } from '../words.ts'
import { packsNamed, printablesNamed, type Printable } from './items.ts'

export const known = {
  paper: { type: 'string' },
  turn: { type: 'string' },
  out: { type: 'string' },
  address: { type: 'string' },
  pupils: { type: 'string' },
  grade: { type: 'string' },
  sets: { type: 'string' },
  grey: { type: 'boolean' },
  json: { type: 'boolean' },
} as const

/** What a call asks to be printed, and how. */
export interface Order {
  readonly items: readonly Printable[]
  readonly languages: readonly Language[]
  /** What cards are printed on: one on A5, or two beside each other on A4. */
  readonly paper: 'a4' | 'a5'
  /** The edge over which two-sided A4 is turned. */
  readonly turn: 'short' | 'long'
  readonly out: string
  /** Where the codes lead; null: none is printed. */
  readonly address: string | null
  readonly grey: boolean
  readonly json: boolean
}

/** Reads the call. @throws CallError */
export function orderOf(args: string[], asked: readonly Language[]): Order {
  const { values, positionals } = options(args, known)
  if (positionals.length === 0) throw new CallError('call.printWhat')
  return {
    items:
      positionals[0] === 'pack'
        ? packsNamed(packsAsked(positionals.slice(1)), {
            pupils: upTo(mostPupils, 'pupils', values.pupils) ?? usualPupils,
            sets: upTo(mostSets, 'sets', values.sets) ?? 1,
            grade: upTo(lastGrade, 'grade', values.grade),
          })
        : printablesNamed(positionals),
    languages: asked.length > 0 ? asked : languages,
    paper: oneOf('paper', values.paper, ['a4', 'a5'] as const),
    turn: oneOf('turn', values.turn, ['short', 'long'] as const),
    out: resolve(values.out ?? '.'),
    address: values.address === undefined ? null : addressOf(values.address),
    grey: values.grey ?? false,
    json: values.json ?? false,
  }
}

function packsAsked(names: readonly string[]): readonly string[] {
  if (names.length === 0) throw new CallError('call.printPack')
  return names
}

const usualPupils = 24
const mostPupils = 99
const mostSets = 20
const lastGrade = 13

/** A whole number from 1 on; null where nothing is said. @throws CallError `call.<name>` for what is none */
function upTo(most: number, name: 'pupils' | 'sets' | 'grade', text: string | undefined): number | null {
  if (text === undefined) return null
  const number = Number(text)
  if (Number.isInteger(number) && number >= 1 && number <= most) return number
  throw new CallError(`call.${name}`, { text, most })
}

function addressOf(text: string): string {
  const url = URL.parse(text)
  if (url === null || !/^https?:$/.test(url.protocol)) throw new CallError('call.address', { text })
  return url.href
}
