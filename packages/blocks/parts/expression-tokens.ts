/** A piece of an expression. `at`: where it begins in the text. */
export interface Token {
  readonly kind: 'number' | 'name' | 'text' | 'colour' | 'sign' | 'end'
  readonly text: string
  readonly at: number
}

/** The text cannot be read; `at`: where. */
export class ExpressionError extends Error {
  readonly at: number
  constructor(at: number) {
    super(`Cannot read the expression at ${at}.`)
    this.at = at
  }
}

const space = /\s+/y
const patterns: readonly (readonly [kind: Token['kind'], pattern: RegExp])[] = [
  ['number', /\d+\.?\d*|\.\d+/y],
  ['colour', /#rgb\(([0-9a-fA-F]{6})\)|#[a-z]+/y],
  ['name', /[\p{L}_][\p{L}\p{N}_]*/uy],
  ['text', /"[^"]*"/y],
  ['sign', /&&|\|\||==|!=|>=|<=|[-+*/%^!<>?:(),.[\]=]/y],
]

/** Cuts a text into its pieces. @throws {ExpressionError} */
export function tokensOf(text: string): readonly Token[] {
  const tokens: Token[] = []
  for (let at = past(space, text, 0); at < text.length; at = past(space, text, at)) {
    const token = tokenAt(text, at)
    tokens.push(token)
    at += token.text.length
  }
  return [...tokens, { kind: 'end', text: '', at: text.length }]
}

function tokenAt(text: string, at: number): Token {
  for (const [kind, pattern] of patterns) {
    const end = past(pattern, text, at)
    if (end > at) return { kind, text: text.slice(at, end), at }
  }
  throw new ExpressionError(at)
}

function past(pattern: RegExp, text: string, at: number): number {
  pattern.lastIndex = at
  const match = pattern.exec(text)
  return match ? at + match[0].length : at
}
