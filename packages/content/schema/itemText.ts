import type { Nodes, PhrasingContent, Root, RootContent } from 'mdast'
import { fromMarkdown } from 'mdast-util-from-markdown'
import { childrenOf, plainNode, plainOf } from './markdown.ts'
import { readEmbed } from './embed.ts'
import type { ItemMarkdown, ItemNode, ItemText, Row, Section } from './itemTypes.ts'

/**
 * Reads an item's words: `# Title`, then a section (a slide) for every `##`; after `### Notes` (named so in every
 * language) comes what only teachers see. Tables are lines of `| cell | cell |`, embeds lines of `::kind{name=value}`.
 * @throws SyntaxError that names the line that is wrong.
 */
export function readItemText(markdown: string): ItemText {
  const { children } = fromMarkdown(markdown) satisfies Root
  const [title, ...rest] = children
  if (title?.type !== 'heading' || title.depth !== 1)
    throw new SyntaxError('The first line must be "# Title".')
  const parts = splitAt(rest, 2)
  const inside = (nodes: readonly RootContent[]) => nodes.flatMap((node) => blocks(node, markdown))
  return {
    title: plainOf(title),
    lead: inside(parts[0]!),
    sections: parts.slice(1).map((nodes) => section(nodes, inside)),
  }
}

/** Nodes in parts: one before the first heading of this depth, then one from each such heading on. */
function splitAt(nodes: readonly RootContent[], depth: number): RootContent[][] {
  const parts: RootContent[][] = [[]]
  for (const node of nodes)
    if (node.type === 'heading' && node.depth === depth) parts.push([node])
    else parts.at(-1)!.push(node)
  return parts
}

const isNotes = (node: RootContent) =>
  node.type === 'heading' && node.depth === 3 && plainOf(node) === 'Notes'

function section(
  [heading, ...nodes]: readonly RootContent[],
  inside: (nodes: readonly RootContent[]) => ItemMarkdown,
): Section {
  const notes = nodes.findIndex(isNotes)
  return {
    title: plainOf(heading!),
    body: inside(notes < 0 ? nodes : nodes.slice(0, notes)),
    notes: inside(notes < 0 ? [] : nodes.slice(notes + 1)),
  }
}

function blocks(node: Nodes, source: string): ItemNode[] {
  const { start, end } = node.position!
  const text = source.slice(start.offset, end.offset)
  try {
    if (node.type === 'paragraph' && text.startsWith('::'))
      return text.split('\n').map((line) => ({ type: 'embed', embed: readEmbed(line) }))
    if (node.type === 'paragraph' && text.startsWith('|')) return [tableOf(text)]
    return [allowed(node, source)]
  } catch (error) {
    if (!(error instanceof SyntaxError) || error.message.startsWith('Line ')) throw error
    throw new SyntaxError(`Line ${start.line}: ${error.message}`, { cause: error })
  }
}

function tableOf(text: string): ItemNode {
  const [head, rule, ...rows] = text.split('\n').map((line) => line.trim().split('|').slice(1, -1))
  if (!head || !rule?.every((cell) => /^ *:?-+:? *$/.test(cell)))
    throw new SyntaxError('A table has a line of "---" below its head.')
  if ([rule, ...rows].some((row) => row.length !== head.length))
    throw new SyntaxError('All lines of a table have equally many cells.')
  return { type: 'table', head: head.map(cellOf), rows: rows.map((row): Row => row.map(cellOf)) }
}

/** Words, bold, links: what stands in a line. */
function cellOf(cell: string): ItemMarkdown {
  const [first] = fromMarkdown(cell.trim()).children
  if (first === undefined) return []
  if (first.type !== 'paragraph') return [{ type: 'text', value: cell.trim() }]
  return first.children.map((node: PhrasingContent) => allowed(node, cell))
}

function allowed(node: Nodes, source: string): ItemNode {
  const inside = (one: Nodes) => blocks(one, source)
  const children = () => childrenOf(node).flatMap(inside)
  if (node.type === 'blockquote') return { type: 'blockquote', children: children() }
  if (node.type === 'heading') return { type: 'heading', depth: node.depth, children: children() }
  if (node.type === 'link') return { type: 'link', href: goodAddress(node.url), children: children() }
  if (node.type === 'image') return { type: 'image', file: node.url, alt: node.alt ?? '' }
  const found = plainNode(node, inside)
  if (found) return found
  throw new SyntaxError(`"${node.type}" is not allowed in an item.`)
}

function goodAddress(url: string): string {
  if (/^(https:\/\/\S+|(item|card):[a-z0-9-]+)$/.test(url)) return url
  throw new SyntaxError(`"${url}" must be https://…, item:… or card:….`)
}
