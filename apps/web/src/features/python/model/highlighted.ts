import { highlightCode, tagHighlighter, tags } from '@lezer/highlight'
import { parser } from '@lezer/python'

/** A piece of a line, and what it is: `keyword`, `name`, `number`, `text`, `note`; '' for the rest. */
export interface Piece {
  readonly text: string
  readonly kind: string
}

const highlighter = tagHighlighter([
  // With its parts: words that define, import, and the like.
  { tag: tags.keyword, class: 'keyword' },
  { tag: [tags.number, tags.bool], class: 'number' },
  { tag: [tags.string, tags.special(tags.string)], class: 'text' },
  { tag: tags.comment, class: 'note' },
  { tag: [tags.function(tags.variableName), tags.function(tags.propertyName)], class: 'name' },
])

/** A file of Python line by line, each in coloured pieces. */
export function highlighted(code: string): readonly (readonly Piece[])[] {
  const lines: Piece[][] = [[]]
  highlightCode(
    code.replace(/\n$/, ''),
    parser.parse(code),
    highlighter,
    (text, kind) => lines.at(-1)!.push({ text, kind }),
    () => lines.push([]),
  )
  return lines
}

const steps: { readonly [key: string]: number } = {
  ...{ ArrowDown: 1, ArrowUp: -1, PageDown: 15, PageUp: -15 },
  ...{ Home: -Infinity, End: Infinity },
}

/** Where a key leads among `count` lines; undefined: it leads nowhere. */
export const lineByKey = (key: string, line: number, count: number): number | undefined =>
  steps[key] === undefined ? undefined : Math.max(0, Math.min(count - 1, line + steps[key]))
