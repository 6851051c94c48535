import type { Nodes } from 'mdast'
import { fromMarkdown } from 'mdast-util-from-markdown'
import { childrenOf, plainNode } from './markdown.ts'
import type { FreeText } from './cardTypes.ts'

type FreeNode = FreeText[number]

/** Where a link may lead: pages, and writing or calling somebody. */
const goodAddress = /^(https?:\/\/|mailto:|tel:)/i

/** Some ten pages. The parser takes the square of some texts' length. */
const mostLetters = 40_000
/** Quotes and lists in each other that one line may open; a page has room for far fewer. */
const mostOpened = 20
/** Levels that are shown; of what lies deeper the words are kept. */
const deepest = 40

/**
 * Reads what somebody has written who runs a lab. Nothing is refused: what may not be shown is left out, and of what is
 * not known the words are kept. HTML is left out; a link that leads elsewhere than to a page or a person is its words.
 * Only the first 40,000 letters are read.
 */
export const readFreeText = (markdown: string): FreeText =>
  fromMarkdown(fewerOpened(markdown.slice(0, mostLetters))).children.flatMap((node) => shown(node, 1))

const marker = /[ \t]*(?:>|(?:[-+*]|\d{1,9}[.)])(?=[ \t]))/.source
const opened = new RegExp(`^((?:${marker}){${mostOpened}})(?:${marker})+`, 'gm')

/** The parser's time grows with the square of the quotes and lists that a line opens, its stack with their number. */
const fewerOpened = (markdown: string) => markdown.replace(opened, '$1')

function shown(node: Nodes, depth: number): FreeNode[] {
  const inside = (child: Nodes) => shown(child, depth + 1)
  const shownInside = () => childrenOf(node).flatMap(inside)
  if (depth > deepest) return [{ type: 'text', value: wordsOf(node) }]
  if (node.type === 'inlineCode' || node.type === 'code') return [{ type: 'text', value: node.value }]
  if (node.type === 'break') return [{ type: 'text', value: '\n' }]
  if (node.type === 'heading') return [{ type: 'heading', children: shownInside() }]
  if (node.type === 'link')
    return goodAddress.test(node.url)
      ? [{ type: 'link', href: node.url, children: shownInside() }]
      : shownInside()
  const found = plainNode(node, inside)
  return found ? [found] : shownInside()
}

/** The words of a node, without recursion. */
function wordsOf(root: Nodes): string {
  const words: string[] = []
  const stack: Nodes[] = [root]
  for (let node = stack.pop(); node; node = stack.pop()) {
    if (node.type === 'text' || node.type === 'inlineCode' || node.type === 'code') words.push(node.value)
    stack.push(...childrenOf(node).toReversed())
  }
  return words.join(' ')
}
