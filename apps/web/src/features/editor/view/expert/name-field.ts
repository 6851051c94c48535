import * as Blockly from 'blockly/core'
import type { FieldLook } from '@botgarten/blocks'
import type { BotBlock } from '../../model/bot-block.ts'
import type { FileField } from '../fields.ts'

type NameLook = FieldLook & { readonly kind: 'name' }

const makers = /^(robGlobalVariables_declare|robLocalVariables_declare|robControls_for|robControls_forEach)$/

/** A name of the program. Where it is made, a new name goes to every block that uses it. */
export class NameField extends Blockly.FieldTextInput implements FileField {
  constructor(look: NameLook, block: BotBlock) {
    super(look.preset, undefined, { spellcheck: false })
    if (look.makes) this.setValidator((name: string) => this.#renamed(look, block, name))
  }

  #renamed(look: NameLook, block: BotBlock, name: string): string | null {
    const clean = name.trim()
    if (clean === '') return null
    const before = String(this.getValue())
    if (clean !== before && !block.isInFlyout && !Blockly.Events.isEnabled()) return clean
    if (clean !== before && !block.isInFlyout) rename(block.workspace, look.of, before, clean)
    return clean
  }

  toFile(): string {
    return String(this.getValue() ?? '')
  }
}

/** Every use of a name gets the new one. */
function rename(workspace: Blockly.Workspace, of: NameLook['of'], before: string, name: string) {
  for (const user of workspace.getAllBlocks(false)) {
    if (of === 'variable' && /^variables_/.test(user.type) && user.getFieldValue('VAR') === before)
      user.setFieldValue(name, 'VAR')
    if (of === 'function' && /^robProcedures_call/.test(user.type)) renameCall(user as BotBlock, before, name)
  }
}

function renameCall(call: BotBlock, before: string, name: string) {
  if (call.extra.attributes?.['name'] !== before) return
  call.loadExtraState?.({ ...call.extra, attributes: { ...call.extra.attributes, name } })
}

/** Variables of a workspace with their types, each name once. */
export function variablesOn(workspace: Blockly.Workspace): readonly { name: string; type: string }[] {
  const found = new Map<string, string>()
  for (const block of workspace.getAllBlocks(true)) {
    if (!makers.test(block.type)) continue
    const name = String(block.getFieldValue('VAR'))
    if (!found.has(name)) found.set(name, String(block.getFieldValue('TYPE') ?? 'Number'))
  }
  return [...found].map(([name, type]) => ({ name, type }))
}
