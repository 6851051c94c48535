import {
  definitions,
  isBlockType,
  toolbox,
  type Block,
  type Template,
  type ValueType,
} from '@botgarten/blocks'
import { fits as fitsIn, outputOf, shapeOf } from '@botgarten/programs'

let anyType = false
/** From now on what a file plugs together stays together, whatever its types: the check says what does not fit. */
export const keepWhatFilesJoin = (): void => void (anyType = true)

/** May the block be plugged into an input that accepts these types? Unknown blocks may go anywhere. */
export function fits(child: Template, accepts: readonly ValueType[] | 'any'): boolean {
  if (!isBlockType(child.type)) return true
  const definition = definitions[child.type]
  const block = { id: '', ...child } as Block
  if (shapeOf(block, definition.look) !== 'value') return false
  return anyType || fitsIn(outputOf(block, definition) ?? 'any', accepts)
}

/** Blockly lets a shadow hold shadows only. */
export function isWholeShadow(block: Template): boolean {
  if (!block.shadow || !isBlockType(block.type) || block.statements) return false
  return Object.values(block.values ?? {}).every(isWholeShadow)
}

/** What comes back when a block is pulled out of this input. */
export const presetShadow = (type: string, input: string): Template | undefined =>
  toolbox
    .flatMap(({ blocks }) => blocks)
    .flatMap((block) => (block.type === type ? [block.values?.[input]] : []))
    .findLast((child) => child?.shadow)
