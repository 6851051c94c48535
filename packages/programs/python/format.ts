// Lines as black leaves them: https://black.readthedocs.io/en/stable/the_black_code_style/current_style.html

const WIDTH = 88
const opening = '([{'
const closing = ')]}'

/** Operators by how black splits at them, the loosest first. */
const splits: readonly RegExp[] = [
  /^ (?=(?:for|if) )/,
  /^, /,
  /^ (?=(?:if|else) )/,
  /^ (?=(?:and|or) )/,
  /^ (?=(?:in|not in|is|<|>|==|!=|<=|>=) )/,
  /^ (?=[+-] )/,
  /^ (?=(?:\*|\/|%|\/\/) )/,
]
const COMPREHENSION = 0
const COMMA = 1

/** Goes over the signs that stand in no text, with the depth of brackets. */
function scan(code: string, visit: (at: number, depth: number) => void): void {
  let depth = 0
  for (let at = 0; at < code.length; at++) {
    const sign = code[at]!
    if (sign === '#') return
    if (sign === '"' || sign === "'") {
      at = endOfText(code, at)
      continue
    }
    if (closing.includes(sign)) depth--
    visit(at, depth)
    if (opening.includes(sign)) depth++
  }
}

function endOfText(code: string, from: number): number {
  let at = from + 1
  while (at < code.length && code[at] !== code[from]) at += code[at] === '\\' ? 2 : 1
  return at
}

interface Parts {
  readonly priority: number
  readonly parts: readonly string[]
}

/** The pieces between the loosest operators that stand in no bracket; null where there are none. */
function splitAt(code: string): Parts | null {
  const found = new Map<number, number[]>()
  let comprehension = false
  scan(code, (at, depth) => {
    if (depth > 0) return
    const rest = code.slice(at)
    comprehension ||= rest.startsWith(' for ')
    const priority = splits.findIndex(
      (split, k) => split.test(rest) && (k !== COMPREHENSION || comprehension),
    )
    if (priority >= 0) found.set(priority, [...(found.get(priority) ?? []), at])
  })
  const priority = Math.min(...found.keys())
  const places = found.get(priority)
  if (!places) return null
  const cuts = [-1, ...places, code.length]
  const parts = cuts
    .slice(1)
    .map((end, k) => code.slice(cuts[k]! + (k === 0 ? 1 : priority === COMMA ? 2 : 1), end))
  return { priority, parts }
}

/** The last bracket on the outside: where it opens and where it closes. */
function lastBracket(code: string): readonly [open: number, close: number] | null {
  let found: readonly [number, number] | null = null
  const opens: number[] = []
  scan(code, (at, depth) => {
    if (opening.includes(code[at]!)) opens[depth] = at
    else if (closing.includes(code[at]!) && depth === 0) found = [opens[0] ?? 0, at]
  })
  return found
}

const heads = /^((?:return|if|elif|while|for .+? in) |[^"'([{=#]+(?:\[[^\]]*\])? [+-]?= )(.+?)(:?)$/s

/** One logical line, split where it is longer than 88 signs. */
export function wrap(code: string, depth: number): readonly string[] {
  const indent = '    '.repeat(depth)
  if (indent.length + code.length <= WIDTH || code.startsWith('#')) return [indent + code]
  const [, head = '', value = '', end = ''] = heads.exec(code) ?? []
  if (head === '' || !wantsBrackets(head, value, depth)) return atBracket(code, depth)
  return [`${indent}${head}(`, ...body(value, depth + 1, false), `${indent})${end}`]
}

/** Whether black puts a value into brackets of its own rather than to split one that is there. */
function wantsBrackets(head: string, value: string, depth: number): boolean {
  const bracket = lastBracket(value)
  const split = splitAt(value)
  const fits = 4 * (depth + 1) + value.length <= WIDTH
  if (!bracket) return split !== null || fits
  if (split === null) return false
  if (split.parts.length > 2) return true
  const closes = bracket[1] === value.length - 1 && bracket[1] > bracket[0] + 1
  return !closes || 4 * depth + head.length + bracket[0] + 1 > WIDTH
}

/** Split at its last bracket: what is inside stands one step further in. */
function atBracket(code: string, depth: number): readonly string[] {
  const indent = '    '.repeat(depth)
  const [open, close] = lastBracket(code) ?? [-1, -1]
  if (open < 0 || close <= open + 1) return [indent + code]
  const inside = code.slice(open + 1, close)
  const calls = /[\w)\]}"']$/.test(code.slice(0, open))
  const pieces = splitAt(inside)?.priority === COMMA
  const rows = !calls && pieces ? exploded(inside, depth + 1, true) : body(inside, depth + 1, calls || pieces)
  return [indent + code.slice(0, open + 1), ...rows, indent + code.slice(close)]
}

/** What stands in brackets: on one line, or a line a piece. */
function body(code: string, depth: number, collects: boolean): readonly string[] {
  const row = '    '.repeat(depth) + code
  return row.length <= WIDTH ? [row] : exploded(code, depth, collects)
}

/** A line a piece; what is still too long is split again. `collects`: a comma stands after the last, too. */
function exploded(code: string, depth: number, collects: boolean): readonly string[] {
  const ends = code.endsWith(',')
  const split = splitAt(ends ? code.slice(0, -1) : code)
  if (!split) return atBracket(code, depth)
  const comma = split.priority === COMMA
  return split.parts.flatMap((part, k) => {
    const last = k === split.parts.length - 1
    return body(part + ((comma && (!last || collects)) || (ends && last) ? ',' : ''), depth, false)
  })
}
