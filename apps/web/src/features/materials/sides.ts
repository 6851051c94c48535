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
