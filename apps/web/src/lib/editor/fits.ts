import { definitions, isBlockType, toolbox, type Face, type Look, type Template } from '@botgarten/blocks'

/** The face a block of a file shows; undefined where its look has only one. */
export function faceOfSource(block: Template, look: Look): Face | undefined {
  const by = look.faces?.by
  if (!by) return undefined
  const key = 'field' in by ? block.fields?.[by.field] : block.mutation?.attrs[by.attribute]
  return look.faces?.of[key ?? ''] ?? Object.values(look.faces?.of ?? {})[0]
}

/** May the block be plugged into an input that accepts these types? Unknown blocks may go anywhere. */
export function fits(child: Template, accepts: readonly string[]): boolean {
  if (!isBlockType(child.type)) return true
  const { look } = definitions[child.type]
  if (look.shape !== 'value') return false
  return accepts.includes(faceOfSource(child, look)?.output ?? look.output ?? '')
}

/** Blockly lets a shadow hold shadows only. */
export function isWholeShadow(block: Template): boolean {
  if (!block.shadow || !isBlockType(block.type) || block.statements) return false
  return Object.values(block.values ?? {}).every(isWholeShadow)
}

const presets: ReadonlyMap<string, Template> = new Map(
  toolbox.flatMap(({ blocks }) =>
    blocks.flatMap(({ type, values }) =>
      Object.entries(values ?? {})
        .filter(([, child]) => child.shadow)
        .map(([input, child]) => [`${type} ${input}`, child] as const),
    ),
  ),
)

/** What comes back when a block is pulled out of this input. */
export const presetShadow = (type: string, input: string): Template | undefined =>
  presets.get(`${type} ${input}`)
