import type { Category, Definition, Template } from './types.ts'

export interface ToolboxCategory {
  readonly category: Category
  readonly blocks: readonly Template[]
}

/** A toolbox with one row more, or with more in a row that is there. */
export function withRow(
  toolbox: readonly ToolboxCategory[],
  more: ToolboxCategory,
): readonly ToolboxCategory[] {
  const at = toolbox.findIndex(({ category }) => category === more.category)
  const row = toolbox[at]
  if (!row) return [...toolbox, more]
  const fresh = more.blocks.filter((block) => !row.blocks.includes(block))
  return toolbox.with(at, { ...row, blocks: [...row.blocks, ...fresh] })
}

const typesIn = ({ type, values = {}, statements = {} }: Template): readonly string[] => [
  type,
  ...Object.values(values).flatMap(typesIn),
  ...Object.values(statements).flat().flatMap(typesIn),
]

/** A pack's blocks that stand nowhere among its presets come last in the row of their family. */
export function withRest(
  presets: readonly ToolboxCategory[],
  pack: { readonly [type: string]: Definition },
): readonly ToolboxCategory[] {
  const offered = new Set(presets.flatMap(({ blocks }) => blocks).flatMap(typesIn))
  return Object.values(pack)
    .filter(({ type, outsideToolbox }) => !outsideToolbox && !offered.has(type))
    .map(({ type, look }) => ({ category: look.category, blocks: [{ type }] }))
    .reduce(withRow, presets)
}
