/** The Markdown a card or whoever runs a lab may write, as a syntax tree (shapes of mdast). Other kinds of nodes are not shown. */
export type MarkdownNode =
  | { readonly type: 'text'; readonly value: string }
  | {
      readonly type: 'paragraph' | 'strong' | 'emphasis' | 'listItem' | 'heading'
      readonly children: readonly MarkdownNode[]
    }
  | { readonly type: 'link'; readonly href: string; readonly children: readonly MarkdownNode[] }
  | { readonly type: 'list'; readonly ordered?: boolean | null; readonly children: readonly MarkdownNode[] }

export type Markdown = readonly MarkdownNode[]
