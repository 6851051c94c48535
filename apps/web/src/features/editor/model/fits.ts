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

const presets = new Map<string, Template>()
for (const { type, values = {} } of toolbox.flatMap(({ blocks }) => blocks))
  for (const [input, child] of Object.entries(values))
    if (child.shadow) presets.set(`${type} ${input}`, child)

/** What comes back when a block is pulled out of this input. */
export const presetShadow = (type: string, input: string): Template | undefined =>
  presets.get(`${type} ${input}`)
