import type { Markdown } from '#parts/markdown.ts'
import { spoken } from '#parts/aloud/spoken.ts'
import type { ItemMarkdown, ItemNode } from '@botgarten/content/items'
import { sayableEmbed } from './sayableEmbed.ts'

type Node = Markdown[number]

const paragraph = (children: Markdown): Node => ({ type: 'paragraph', children })
const sentence = (value: string): Node => paragraph([{ type: 'text', value }])
const said = (nodes: ItemMarkdown): Markdown => nodes.flatMap(saidOf)

/** What a voice says of a node: pictures by their words, tables row by row. */
function saidOf(node: ItemNode): Markdown {
  switch (node.type) {
    case 'text':
      return [node]
    case 'embed':
      return sayableEmbed(node.embed).map(sentence)
    case 'image':
      return [sentence(node.alt)]
    case 'table':
      return [node.head, ...node.rows].map((row) =>
        paragraph(
          row
            .filter((cell) => cell.length > 0)
            .flatMap((cell, index) => [
              ...(index > 0 ? [{ type: 'text', value: ', ' } as const] : []),
              ...said(cell),
            ]),
        ),
      )
    case 'list':
      return [{ type: 'list', ordered: node.ordered, children: said(node.children) }]
    case 'listItem':
      return [{ type: 'listItem', children: [paragraph(said(node.children).flatMap(within))] }]
    case 'strong':
    case 'emphasis':
    case 'link':
      return said(node.children)
    default:
      return [paragraph(said(node.children))]
  }
}

/** A line of a list is one sentence, however it is written. */
const within = (node: Node): Markdown => (node.type === 'paragraph' ? node.children : [node])

/** The words of an item as a voice says them; null where there are none. */
export const sayable = (nodes: ItemMarkdown): string | null => spoken(said(nodes)) || null
