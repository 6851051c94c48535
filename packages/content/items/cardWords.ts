import type { CardText, MarkdownNode } from '../schema/cardTypes.ts'

const plain = (node: MarkdownNode): string =>
  'value' in node ? node.value : node.children.map(plain).join(node.type === 'list' ? '\n' : '')

/** The words of a text, a paragraph on a line. */
export const lines = (nodes: readonly MarkdownNode[]): string => nodes.map(plain).join('\n')

/** All that a child reads on a card, a paragraph or line of a list on a line. */
export const cardWords = ({ title, story, goal, checks, hints, further }: CardText): string =>
  [
    ...[title, lines(story), goal.call, goal.sentence],
    ...Object.values(checks),
    ...[...hints.map(lines), lines(further)],
  ].join('\n')
