// The rows of words.json as rules, and the places where a text matches them.
import { readFileSync } from 'node:fs'
import { inHouse } from '../prepare/house.mjs'
import { isDocument, passagesOf, type Passage } from './passages.ts'

export type Kind = 'comments' | 'documents'

/** A row of words.json. In both patterns a space also matches a line break; case is ignored. */
export interface Row {
  readonly name: string
  readonly pattern: string
  /** Ordinary English that contains the pattern. It wins if it begins no later than the pattern. */
  readonly except?: string
  readonly better: string
  readonly example: string
  readonly counterExample: string
  readonly where: readonly Kind[]
}

export interface Match {
  readonly rule: string
  readonly better: string
  readonly phrase: string
  readonly line: number
}

export const rows = JSON.parse(readFileSync(inHouse('scripts', 'prose', 'words.json'), 'utf8')) as Row[]

const flexible = (pattern: string) => pattern.replaceAll(' ', '\\s+')

const expressionOf = ({ pattern, except }: Row) =>
  new RegExp(`${except ? `(?:${flexible(except)})|` : ''}(?<phrase>${flexible(pattern)})`, 'gi')

const rules = rows.map((row) => ({ row, expression: expressionOf(row) }))

/** All matches of the rows for this kind of text, row by row. */
export const matchesIn = ({ text, line }: Passage, kind: Kind): Match[] =>
  rules
    .filter(({ row }) => row.where.includes(kind))
    .flatMap(({ row, expression }) =>
      [...text.matchAll(expression)].flatMap(({ groups, index }) => {
        const phrase = groups?.['phrase']
        if (phrase === undefined) return []
        return [{ rule: row.name, better: row.better, phrase, line: line + lineBreaks(text.slice(0, index)) }]
      }),
    )

const lineBreaks = (text: string) => text.split('\n').length - 1

const kindOf = (path: string): Kind => (isDocument(path) ? 'documents' : 'comments')

/** Matches of a file in the order of its lines. */
export const matchesOf = (path: string, text: string): Match[] =>
  passagesOf(path, text)
    .flatMap((passage) => matchesIn(passage, kindOf(path)))
    .sort((one, other) => one.line - other.line)

export const wordsIn = ({ text }: Passage): number => text.match(/[a-z][a-z'’-]*/gi)?.length ?? 0
