import type { Markdown } from '../markdown.ts'

type Node = Markdown[number]

/** What a voice says for a text: each paragraph and each line of a list with a pause behind it. */
export function spoken(tree: Markdown): string {
  return tree.map(said).join(' ').replace(/\s+/g, ' ').trim()
}

function said(node: Node): string {
  if (node.type === 'text') return node.value
  const inside = node.children.map(said).join(node.type === 'list' ? ' ' : '')
  return node.type === 'paragraph' && !/[.!?:]\s*$/.test(inside) ? `${inside}.` : inside
}
