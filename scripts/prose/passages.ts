// Extracts the prose of a file: comments of code, paragraphs and headings of Markdown.
import { componentComments, hashComments, scriptComments, styleComments, type Range } from './comments.ts'
import { paragraphsOf } from './markdown.ts'

/** A comment, a run of line comments, a paragraph or a heading. */
export interface Passage {
  /** Line of the file in which the text begins, from 1. */
  readonly line: number
  /** Has a line for each line of the file. Code in it is replaced by `X`. */
  readonly text: string
}

const findComments: { readonly [extension: string]: (text: string) => Range[] } = {
  ts: scriptComments,
  js: scriptComments,
  mjs: scriptComments,
  svelte: componentComments,
  css: styleComments,
  sh: hashComments,
  py: hashComments,
}

const extensionOf = (path: string) => path.slice(path.lastIndexOf('.') + 1)

export const isDocument = (path: string): boolean => extensionOf(path) === 'md'

/** Whether `passagesOf` can read files of this kind. */
export const hasProse = (path: string): boolean => isDocument(path) || extensionOf(path) in findComments

/** @throws Error if a component cannot be parsed, or files of this kind cannot be read */
export function passagesOf(path: string, text: string): Passage[] {
  if (isDocument(path)) return paragraphsOf(text)
  const find = findComments[extensionOf(path)]
  if (!find) throw new Error(`${path}: cannot extract prose from files of this kind.`)
  return joined(text, find(text)).map((passage) => ({ ...passage, text: withoutCode(passage.text) }))
}

/** Makes one passage of comments that only white space and at most one line break separate. */
function joined(text: string, comments: readonly Range[]): Passage[] {
  const passages: { line: number; text: string }[] = []
  let line = 1
  let counted = 0
  let end = 0
  for (const comment of comments) {
    line += lineBreaks(text.slice(counted, comment.start))
    counted = comment.start
    const gap = text.slice(end, comment.start)
    const words = withoutDelimiters(text.slice(comment.start, comment.end))
    const last = passages.at(-1)
    if (last && /^[ \t]*\r?\n?[ \t]*$/.test(gap)) last.text += (gap.includes('\n') ? '\n' : ' ') + words
    else passages.push({ line, text: words })
    end = comment.end
  }
  return passages
}

const lineBreaks = (text: string) => text.split('\n').length - 1

const withoutDelimiters = (comment: string) =>
  comment
    .replace(/^(?:\/\/+|\/\*+!?|<!--|[ \t]*#+)/, '')
    .replace(/(?:\*\/|-->)$/, '')
    .replace(/^[ \t]*\*/gm, '')

/** Removes fenced blocks, and replaces inline code, links to code and URLs by one word. */
const withoutCode = (text: string) =>
  text
    .replace(/^[ \t]*```[^]*?(?:^[ \t]*```|$(?![^]))/gm, (code) => '\n'.repeat(lineBreaks(code)))
    .replace(/`[^`]*`|\{@[^}]*\}|\bhttps?:\/\/\S+/g, (code) => `X${'\n'.repeat(lineBreaks(code))}`)
