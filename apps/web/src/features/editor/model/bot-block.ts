import * as Blockly from 'blockly/core'
import type { Block, Definition, Face, Look } from '@botgarten/blocks'
import type { Frame } from '../view/renderer.ts'

/** What a block of a file holds that its look does not show. It stays with the block, also through copy and undo. */
export interface Rest {
  readonly fields?: Block['fields']
  readonly values?: Block['values']
  readonly statements?: Block['statements']
  readonly data?: string
  readonly hide?: readonly string[]
  readonly inline?: boolean
  readonly flags?: Block['flags']
  readonly shadow?: boolean
  readonly args?: NonNullable<Block['mutation']>['args']
  /** What the file wrote of that which the look writes always; a block from the toolbox has none of this. */
  readonly told?: {
    readonly fields: readonly string[]
    readonly attributes: readonly string[] | null
    /** Fields that the mutation repeats, as the file had them: while they stay, so does the mutation. */
    readonly repeated?: Block['fields']
  }
}

/** The state of a block besides its fields and its neighbours: plain data, Blockly's extra state. */
export interface Extra {
  /** Attributes of the mutation as they were loaded; what the look writes itself is put over them. */
  readonly attributes?: { readonly [name: string]: string }
  /** Names of the inputs of a growing list, from the top. They keep their names while the list changes. */
  readonly lines?: readonly string[]
  /** Value of the field that tells the face: the plug must fit before fields are loaded. */
  readonly face?: string
  /** The block's own id: where it is not, the block is a copy. Neurons and layers of them alone carry it. */
  readonly self?: string
  readonly rest?: Rest
}

/** A block that is drawn from a definition. */
export interface BotBlock extends Blockly.Block {
  definition: Definition
  extra: Extra
  frame: Frame | null
  /** The block that this one was copied from. */
  copyOf: string | null
}

export const isBotBlock = (block: Blockly.Block | null): block is BotBlock =>
  block !== null && 'definition' in block

/** The value that tells which face a block shows. */
function faceKey(look: Look, block: BotBlock): string | undefined {
  const by = look.faces?.by
  if (by === undefined) return undefined
  if ('field' in by) return block.getFieldValue(by.field) as string
  return block.extra.attributes?.[by.attribute] ?? constant(look.mutation?.[by.attribute])
}

const constant = (value: string | { field: string } | undefined) =>
  typeof value === 'string' ? value : undefined

/** The face a block shows now; undefined where its look has only one. */
export function faceOf(block: BotBlock): Face | undefined {
  const { look } = block.definition
  const key = faceKey(look, block)
  return (key === undefined ? undefined : look.faces?.of[key]) ?? Object.values(look.faces?.of ?? {})[0]
}

/** Colours of the frame round a list; every family that has lists has one. */
const layerStyle = ({ category }: Look) => (category === 'q-learning' ? 'roads' : 'layer')
let typedOutput: (block: BotBlock) => string | null = () => null
/** From now on this says what a block of a chosen type gives (expert pack). */
export const knowTypes = (know: typeof typedOutput): void => void (typedOutput = know)

/** Gives the block the plug and the frame of its face. */
export function applyFace(block: BotBlock): void {
  const { look } = block.definition
  if (look.shape !== 'value' || block.previousConnection) return
  const face = faceOf(block)
  block.frame = face?.items ? { plug: face.plug ?? 'round', tint: face.tint ?? 'sensor' } : null
  if (look.layer) block.frame = { plug: 'pointed', tint: look.layer }
  block.setStyle(block.frame ? layerStyle(look) : look.category)
  const output = typedOutput(block) ?? face?.output ?? look.output ?? 'any'
  block.setOutput(true, output === 'any' ? null : output)
}

export function faceField(look: Look): string | undefined {
  const by = look.faces?.by
  if (by && 'field' in by) return by.field
  const when = look.also?.when
  return when && 'field' in when ? when.field : undefined
}
