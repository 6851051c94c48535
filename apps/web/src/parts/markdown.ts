/** The Markdown a card or the operator of a lab may write, as a syntax tree (shapes of mdast). Other kinds of nodes are not shown. */
export type MarkdownNode =
  | { readonly type: 'text'; readonly value: string }
  | {
      readonly type: 'paragraph' | 'strong' | 'emphasis' | 'listItem' | 'heading'
      readonly children: readonly MarkdownNode[]
    }
  | { readonly type: 'link'; readonly href: string; readonly children: readonly MarkdownNode[] }
  | { readonly type: 'list'; readonly ordered?: boolean | null; readonly children: readonly MarkdownNode[] }

export type Markdown = readonly MarkdownNode[]

/** What a voice says for a text: each paragraph and each line of a list with a pause behind it. */
export function spoken(tree: Markdown): string {
  return tree.map(said).join(' ').replace(/\s+/g, ' ').trim()
}

function said(node: MarkdownNode): string {
  if (node.type === 'text') return node.value
  const inside = node.children.map(said).join(node.type === 'list' ? ' ' : '')
  return node.type === 'paragraph' && !/[.!?:]\s*$/.test(inside) ? `${inside}.` : inside
}
