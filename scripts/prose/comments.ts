// Finds the comments of a source file with the parser of its language: a string that looks like a comment is none.
import { parse as parseSvelte } from 'svelte/compiler'
import ts from 'typescript'

/** From `start` up to, but without, `end`: offsets in UTF-16 units. */
export interface Range {
  readonly start: number
  readonly end: number
}

const parsing: ts.CreateSourceFileOptions = {
  languageVersion: ts.ScriptTarget.Latest,
  jsDocParsingMode: ts.JSDocParsingMode.ParseNone,
}

/** Outside of strings, templates and regular expressions, only a comment can begin with `//` or `/*`. */
export function scriptComments(text: string): Range[] {
  const tree = ts.createSourceFile('script.ts', text, parsing)
  const literals: Range[] = []
  const visit = (node: ts.Node): void => {
    if (isLiteral(node)) literals.push({ start: node.getStart(tree), end: node.end })
    ts.forEachChild(node, visit)
  }
  visit(tree)
  return commentsBetween(text, literals)
}

const isLiteral = (node: ts.Node) =>
  ts.isStringLiteral(node) ||
  ts.isRegularExpressionLiteral(node) ||
  ts.isNoSubstitutionTemplateLiteral(node) ||
  ts.isTemplateHead(node) ||
  ts.isTemplateMiddleOrTemplateTail(node)

/** @param literals in the order of the text */
function commentsBetween(text: string, literals: readonly Range[]): Range[] {
  const found: Range[] = []
  let at = 0
  for (const { start, end } of [...literals, { start: text.length, end: text.length }]) {
    for (let next = nextComment(text, at, start); next >= 0; next = nextComment(text, at, start)) {
      at = endOfComment(text, next)
      found.push({ start: next, end: at })
    }
    at = Math.max(at, end)
  }
  return found
}

/** @returns −1 if no comment begins before `end` */
function nextComment(text: string, from: number, end: number): number {
  for (let at = text.indexOf('/', from); at >= 0 && at < end; at = text.indexOf('/', at + 1))
    if (text[at + 1] === '/' || text[at + 1] === '*') return at
  return -1
}

function endOfComment(text: string, start: number): number {
  const isBlock = text[start + 1] === '*'
  const end = text.indexOf(isBlock ? '*/' : '\n', start + 2)
  if (end < 0) return text.length
  return isBlock ? end + 2 : end
}

/** Comments of the scripts, the markup and the styles of a Svelte component, in the order of the text. */
export function componentComments(text: string): Range[] {
  if (!/\/[/*]|<!--/.test(text)) return []
  const tree = parseSvelte(text, { modern: true })
  const found: Range[] = tree.comments.map(({ start, end }) => ({ start, end }))
  const visit = (node: unknown): void => {
    if (Array.isArray(node)) node.forEach(visit)
    else if (isNode(node)) {
      if (node.type === 'Comment') found.push({ start: node.start, end: node.end })
      Object.values(node).forEach(visit)
    }
  }
  visit(tree.fragment)
  if (tree.css) {
    const { start: offset, styles } = tree.css.content
    for (const { start, end } of styleComments(styles))
      found.push({ start: start + offset, end: end + offset })
  }
  return found.sort((one, other) => one.start - other.start)
}

const isNode = (value: unknown): value is Range & { type: string } =>
  typeof value === 'object' && value !== null && 'type' in value

/** Comments, strings and URLs of CSS: each may contain the delimiters of the others. */
const styleTokens = /\/\*[^]*?(?:\*\/|$(?![^]))|"(?:\\[^]|[^"\\])*"|'(?:\\[^]|[^'\\])*'|url\([^)]*\)/g

export const styleComments = (text: string): Range[] =>
  [...text.matchAll(styleTokens)]
    .filter(([token]) => token.startsWith('/*'))
    .map(({ index, 0: token }) => ({ start: index, end: index + token.length }))

/** Shell and Python: lines that hold nothing but a comment. */
export const hashComments = (text: string): Range[] =>
  [...text.matchAll(/^[ \t]*#(?!!).*$/gm)].map(({ index, 0: line }) => ({
    start: index,
    end: index + line.length,
  }))
