import type { Embed } from '../schema/embed.ts'
import { plainOf } from '../schema/markdown.ts'
import type { ItemMarkdown, ItemNode, ItemText } from '../schema/itemTypes.ts'

/** All nodes of an item in reading order. */
export function* nodesOf(text: ItemText, withNotes = true): Generator<ItemNode> {
  yield* inside(text.lead)
  for (const { body, notes } of text.sections) {
    yield* inside(body)
    if (withNotes) yield* inside(notes)
  }
}

/** The words of an item, a paragraph, heading or line of a list on a line; those of tables left out. */
export const wordsOf = (text: ItemText, withNotes = true): string =>
  [
    text.title,
    ...text.sections.map(({ title }) => title),
    ...[...nodesOf(text, withNotes)]
      .filter(({ type }) => type === 'paragraph' || type === 'heading')
      .map(plainOf),
  ].join('\n')

/** All nodes in these, in reading order. */
export const nodesInside = (nodes: ItemMarkdown): Generator<ItemNode> => inside(nodes)

function* inside(nodes: ItemMarkdown): Generator<ItemNode> {
  for (const node of nodes) {
    yield node
    if ('children' in node) yield* inside(node.children)
    if (node.type === 'table') for (const row of [node.head, ...node.rows]) yield* inside(row.flat())
  }
}

export const embedsOf = (text: ItemText): readonly Embed[] =>
  [...nodesOf(text)].flatMap((node) => (node.type === 'embed' ? [node.embed] : []))

/** What must be the same in every language, as lines: sections, notes, headings, lists, tables, pictures, embeds, links. */
export const shapeOf = (text: ItemText): readonly string[] =>
  [{ title: '', body: text.lead, notes: [] as ItemMarkdown }, ...text.sections].flatMap(({ body, notes }) => [
    'section',
    ...shape(body),
    ...(notes.length > 0 ? ['notes'] : []),
  ])

const shape = (nodes: ItemMarkdown): string[] =>
  [...inside(nodes)].flatMap((node) => {
    switch (node.type) {
      case 'heading':
        return [`heading ${node.depth}`]
      case 'list':
        return [`list of ${node.children.length}`]
      case 'table':
        return [`table of ${node.rows.length} × ${node.head.length}`]
      case 'image':
        return ['image']
      case 'link':
        return [/^(item|card):/.test(node.href) ? node.href : 'link']
      case 'embed':
        return [JSON.stringify(node.embed)]
      default:
        return []
    }
  })
