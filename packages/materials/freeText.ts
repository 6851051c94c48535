import type { Nodes } from 'mdast'
import { fromMarkdown } from 'mdast-util-from-markdown'
import { childrenOf, plainNode } from './markdown.ts'
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

const shownInside = (node: Nodes): FreeNode[] => childrenOf(node).flatMap(shown)

function shown(node: Nodes): FreeNode[] {
  if (node.type === 'inlineCode' || node.type === 'code') return [{ type: 'text', value: node.value }]
  if (node.type === 'break') return [{ type: 'text', value: '\n' }]
  if (node.type === 'heading') return [{ type: 'heading', children: shownInside(node) }]
  if (node.type === 'link')
    return goodAddress.test(node.url)
      ? [{ type: 'link', href: node.url, children: shownInside(node) }]
      : shownInside(node)
  const found = plainNode(node, shown)
  return found ? [found] : shownInside(node)
}
