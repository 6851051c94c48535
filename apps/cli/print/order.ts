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
export function orderOf(args: string[], language?: Language): Order {
  const { values, positionals } = options(args, known)
  if (positionals.length === 0) throw new CallError('call.printWhat')
  return {
    items:
      positionals[0] === 'pack'
        ? packsNamed(packsAsked(positionals.slice(1)), {
            pupils: pupilsOf(values.pupils),
            grade: gradeOf(values.grade),
          })
        : printablesNamed(positionals),
    languages: language ? [language] : languages,
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

function pupilsOf(text: string | undefined): number {
  const pupils = text === undefined ? usualPupils : Number(text)
  if (Number.isInteger(pupils) && pupils >= 1 && pupils <= mostPupils) return pupils
  throw new CallError('call.pupils', { text: text!, most: mostPupils })
}

function gradeOf(text: string | undefined): number | null {
  if (text === undefined) return null
  const grade = Number(text)
  if (Number.isInteger(grade) && grade >= 1 && grade <= 13) return grade
  throw new CallError('call.grade', { text })
}

function addressOf(text: string): string {
  const url = URL.parse(text)
  if (url === null || !/^https?:$/.test(url.protocol)) throw new CallError('call.address', { text })
  return url.href
}
