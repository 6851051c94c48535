import { blocks as core } from './packs/core/blocks.ts'
import { plainToolbox } from './packs/core/toolbox.ts'
import { packs, type BlockType } from './packs/packs.ts'
import { withRow, type ToolboxCategory } from './toolbox.ts'
import type { Definition, Pack } from './types.ts'

/**
 * The blocks that are loaded, by type: what most cards need at once, those for maps and for groups after
 * `addBlocks(learning, learningToolbox)` (`@botgarten/blocks/packs/learning`), the whole language after `addBlocks(expert)`
 * (`@botgarten/blocks/packs/expert`). Ask `isBlockType` before a look-up.
 */
export const definitions: { readonly [T in BlockType]: Definition } = { ...core } as never

/** What is loaded of the plain toolbox: `addBlocks` puts more into it. */
export const toolbox: ToolboxCategory[] = [...plainToolbox]

/** Makes more of the language known, in place; `rows` are in the toolbox from then on. */
export function addBlocks(
  more: { readonly [type: string]: Definition },
  rows: readonly ToolboxCategory[] = [],
): void {
  Object.assign(definitions, more)
  toolbox.splice(0, Infinity, ...rows.reduce(withRow, toolbox))
}

/** The pack of a block, loaded or not; undefined where there is no such block. */
export const packOf = (type: string): Pack | undefined =>
  Object.hasOwn(packs, type) ? packs[type as BlockType] : undefined

/** Is it a block that is loaded? Files may hold others; they are kept and cannot run. */
export const isBlockType = (type: string): type is BlockType => Object.hasOwn(definitions, type)
