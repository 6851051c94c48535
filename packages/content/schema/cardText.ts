import type { Nodes, Root, RootContent } from 'mdast'
import { fromMarkdown } from 'mdast-util-from-markdown'
import { plainNode, plainOf } from './markdown.ts'
import type { CardText, MarkdownNode } from './cardTypes.ts'

/**
 * Reads a card's words: `# Title`, then the sections Story, Goal, Checks, Hint 1 to 3 and Further (named so in every language).
 * @throws SyntaxError that names what is missing or not allowed.
 */
export function readCardText(markdown: string): CardText {
  const root = fromMarkdown(markdown)
  const sections = sectionsOf(root)
  const section = (name: string) => {
    const nodes = sections.get(name)
    if (!nodes?.length) throw new SyntaxError(`The section "${name}" is missing.`)
    return nodes.map(allowed)
  }
  const title = root.children[0]
  if (title?.type !== 'heading' || title.depth !== 1)
    throw new SyntaxError('The first line must be "# Title".')
  return {
    title: plainOf(title),
    story: section('Story'),
    goal: goalOf(sections.get('Goal')),
    checks: checksOf(sections.get('Checks')),
    hints: [section('Hint 1'), section('Hint 2'), section('Hint 3')],
    further: section('Further'),
  }
}

/** The title alone, without reading the rest. @throws SyntaxError where the first line is none */
export function titleOf(markdown: string): string {
  const [first] = fromMarkdown(/^.*/.exec(markdown)![0]).children
  if (first?.type === 'heading' && first.depth === 1) return plainOf(first)
  throw new SyntaxError('The first line must be "# Title".')
}

function sectionsOf(root: Root): Map<string, RootContent[]> {
  const sections = new Map<string, RootContent[]>()
  let open: RootContent[] = []
  for (const node of root.children.slice(1)) {
    if (node.type !== 'heading') open.push(node)
    else sections.set(plainOf(node), (open = []))
  }
  return sections
}

/** `**Call** Sentence.` */
function goalOf(nodes: readonly RootContent[] | undefined): CardText['goal'] {
  const paragraph = nodes?.[0]
  const call = paragraph?.type === 'paragraph' ? paragraph.children[0] : undefined
  if (paragraph?.type !== 'paragraph' || call?.type !== 'strong')
    throw new SyntaxError('The section "Goal" must be "**Call** Sentence."')
  return { call: plainOf(call), sentence: paragraph.children.slice(1).map(plainOf).join('').trim() }
}

/** A list of `id: what is to be seen`. */
function checksOf(nodes: readonly RootContent[] | undefined): CardText['checks'] {
  const list = nodes?.[0]
  if (list?.type !== 'list') throw new SyntaxError('The section "Checks" must be a list of "id: words".')
  return Object.fromEntries(
    list.children.map((item) => {
      const [, id, words] = /^(\w+): (.+)$/.exec(plainOf(item)) ?? []
      if (!id || !words) throw new SyntaxError(`The check "${plainOf(item)}" must be "id: words".`)
      return [id, words]
    }),
  )
}

function allowed(node: Nodes): MarkdownNode {
  const found = plainNode(node, allowed)
  if (found) return found
  throw new SyntaxError(`Line ${node.position?.start.line}: "${node.type}" is not allowed in a card.`)
}
