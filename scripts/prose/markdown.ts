import { fromMarkdown } from 'mdast-util-from-markdown'
import type { Passage } from './passages.ts'

interface MarkdownNode {
  readonly type: string
  readonly value?: string
  readonly children?: readonly MarkdownNode[]
  readonly position?: { readonly start: { readonly line: number } } | undefined
}

/** Paragraphs, headings and rows of tables; fenced and indented code is left out, inline code is replaced by `X`. */
export function paragraphsOf(text: string): Passage[] {
  const passages: Passage[] = []
  const visit = (node: MarkdownNode): void => {
    if (isText(node)) passages.push({ line: node.position?.start.line ?? 1, text: plain(node) })
    else node.children?.forEach(visit)
  }
  visit(fromMarkdown(text))
  return passages
}

const isText = ({ type }: MarkdownNode) => type === 'paragraph' || type === 'heading'

const plain = ({ type, value = '', children = [] }: MarkdownNode): string => {
  if (type === 'text') return value
  if (type === 'inlineCode') return value.replace(/[^\n]+/, 'X')
  if (type === 'break') return '\n'
  return children.map(plain).join('')
}
