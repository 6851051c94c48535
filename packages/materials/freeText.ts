import type { Nodes } from 'mdast'
import { fromMarkdown } from 'mdast-util-from-markdown'
import type { FreeText } from './types.ts'

type FreeNode = FreeText[number]

/** Where a link may lead: pages, and writing or calling somebody. */
const goodAddress = /^(https?:\/\/|mailto:|tel:)/i

/**
 * Reads what somebody has written who runs a lab. Nothing is refused: what may not be shown is left out, and of what is
 * not known the words are kept. HTML is left out; a link that leads elsewhere than to a page or a person is its words.
 */
export const readFreeText = (markdown: string): FreeText =>
  fromMarkdown(markdown).children.flatMap((node) => shown(node))

const shownInside = (node: Nodes): FreeNode[] => ('children' in node ? node.children.flatMap(shown) : [])

function shown(node: Nodes): FreeNode[] {
  switch (node.type) {
    case 'text':
      return [{ type: 'text', value: node.value }]
    case 'inlineCode':
    case 'code':
      return [{ type: 'text', value: node.value }]
    case 'break':
      return [{ type: 'text', value: '\n' }]
    case 'strong':
    case 'emphasis':
    case 'paragraph':
    case 'listItem':
    case 'heading':
      return [{ type: node.type, children: shownInside(node) }]
    case 'list':
      return [{ type: 'list', ordered: node.ordered ?? false, children: shownInside(node) }]
    case 'link':
      return goodAddress.test(node.url)
        ? [{ type: 'link', href: node.url, children: shownInside(node) }]
        : shownInside(node)
    default:
      return shownInside(node)
  }
}
