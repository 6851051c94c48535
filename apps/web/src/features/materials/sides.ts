import type { ItemMarkdown, ItemNode, ItemText } from '@botgarten/content/items'

/** A title as it would be written in the text. */
export const headingOf = (title: string): ItemNode => ({
  type: 'heading',
  depth: 2,
  children: [{ type: 'text', value: title }],
})

const isPage = (node: ItemNode) => node.type === 'embed' && node.embed.kind === 'page'

/** An item as its sides of paper: what stands between two `::page`. An empty one is left out. */
export function sidesOf({ lead, sections }: ItemText): readonly ItemMarkdown[] {
  const all = [...lead, ...sections.flatMap(({ title, body }) => [headingOf(title), ...body])]
  const sides: ItemNode[][] = [[]]
  for (const node of all)
    if (isPage(node)) sides.push([])
    else sides.at(-1)!.push(node)
  return sides.filter((side) => side.length > 0)
}

/** A side of paper, or a slide: its heading where it has one of its own, and what stands below. */
export interface Leaf {
  readonly title: string | null
  readonly nodes: ItemMarkdown
}

/** The slides of a deck: the title first, then one for every section. Notes are for the teacher alone. */
const slidesOf = ({ title, lead, sections }: ItemText): readonly Leaf[] => [
  { title, nodes: lead },
  ...sections.map((section) => ({ title: section.title, nodes: section.body })),
]

/** An item as what is printed of it. */
export const leavesOf = (text: ItemText, paper: string): readonly Leaf[] =>
  paper === '16:9' ? slidesOf(text) : sidesOf(text).map((nodes) => ({ title: null, nodes }))

/** A heading that begins with the number of a task, as “2 Find your knobs”, or is one alone. Null: it does not. */
export function taskOf(node: ItemNode): { readonly number: string; readonly rest: string } | null {
  if (node.type !== 'heading' || node.children.length !== 1) return null
  const [text] = node.children
  const found = text?.type === 'text' && /^(\d)(?: (.+))?$/.exec(text.value)
  return found ? { number: found[1]!, rest: found[2] ?? '' } : null
}

/** A paragraph or a list without a picture. */
export const isWords = (node: ItemNode): boolean =>
  node.type === 'list' || (node.type === 'paragraph' && node.children.every(({ type }) => type !== 'image'))
