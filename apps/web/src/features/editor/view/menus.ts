import * as Blockly from 'blockly/core'
import { isBotBlock } from '../model/bot-block.ts'
import { registerNotes, toggleNote } from './note-icon.ts'
import { m } from '#words/message.ts'
import { readSetting, writeSetting } from '#storage/settings.ts'

type CopyData = Blockly.clipboard.BlockCopyData
type State = Blockly.serialization.blocks.State

const { ContextMenuRegistry, ShortcutRegistry, clipboard, Msg } = Blockly
/** Items of Blockly's menus that a child does not need: the page has its own, or they are for grown-ups. */
const notForUs = ['undoWorkspace', 'redoWorkspace', 'workspaceDelete', 'blockInline', 'blockHelp']
/** Where this device keeps what was copied, for other projects and other tabs. */
const place = 'copied'

/** By workspace: brings the whole language to it. */
const teachers = new WeakMap<Blockly.Workspace, () => Promise<void>>()
/** What is pasted may need more of the language than the workspace knows: `teach` brings it. */
export const letPaste = (workspace: Blockly.Workspace, teach: () => Promise<void>) =>
  teachers.set(workspace, teach)

/** By workspace: tells what blocks of a type do. */
const askers = new WeakMap<Blockly.Workspace, (type: string) => void>()
export const letAsk = (workspace: Blockly.Workspace, ask: (type: string) => void) =>
  askers.set(workspace, ask)

/** Menus of the blocks and of the workspace, and copies that can be taken along. */
export function setUpMenus(): void {
  const { registry } = ContextMenuRegistry
  for (const id of notForUs) if (registry.getItem(id)) registry.unregister(id)
  const { BLOCK, WORKSPACE } = ContextMenuRegistry.ScopeType
  registry.register({
    id: 'blockCopy',
    weight: 0,
    scopeType: BLOCK,
    displayText: () => withKey(Msg['COPY_SHORTCUT'], 'C'),
    preconditionFn: ({ block }) => (block?.isDeletable() && !block.isInFlyout ? 'enabled' : 'hidden'),
    callback: ({ block }) => block && keep(clipboard.copy(block)),
  })
  registry.register({
    id: 'paperPaste',
    weight: 0,
    scopeType: WORKSPACE,
    displayText: () => withKey(Msg['PASTE_SHORTCUT'], 'V'),
    preconditionFn: () => (kept() ? 'enabled' : 'disabled'),
    callback: ({ workspace }, opened) => {
      if (workspace) void paste(workspace, opened)
    },
  })
  registry.register({
    id: 'blockExplain',
    weight: -1,
    scopeType: BLOCK,
    displayText: () => m['editor.what'](),
    preconditionFn: ({ block }) => (isBotBlock(block ?? null) ? 'enabled' : 'hidden'),
    callback: ({ block }) => block && askers.get(workspaceOf(block.workspace))?.(block.type),
  })
  const comment = registry.getItem('blockComment')
  if (comment && !comment.separator) {
    registry.unregister(comment.id)
    const callback = ({ block }: Blockly.ContextMenuRegistry.Scope) => block && void toggleNote(block)
    registry.register({ ...comment, callback })
  }
  registerNotes()
  takeCopiesAlong()
}

/** Blockly names the control key once, before it has been told a language. */
function withKey(text: string | undefined, letter: string): HTMLElement {
  const keys = Blockly.utils.userAgent.APPLE ? `⌘ ${letter}` : `${Msg['CONTROL_KEY']} + ${letter}`
  const line = Object.assign(document.createElement('div'), { className: 'blocklyShortcutContainer' })
  const key = Object.assign(document.createElement('span'), { className: 'blocklyShortcut' })
  key.textContent = keys
  line.append(text ?? '', key)
  return line
}

/** Blockly's keys for copies, for every workspace there is. */
function takeCopiesAlong() {
  for (const name of ['copy', 'cut'])
    change(name, ({ callback }) => ({
      callback: (...all) => callback!(...all) && keep(clipboard.getLastCopiedData()),
    }))
  change('paste', ({ preconditionFn, callback }) => ({
    preconditionFn: (workspace, scope) => take(workspace) && preconditionFn!(workspace, scope),
    callback(...all) {
      void taught(all[0]).then(() => callback!(...all))
      return true
    },
  }))
}

type Shortcut = Blockly.ShortcutRegistry.KeyboardShortcut

function change(name: string, how: (shortcut: Shortcut) => Partial<Shortcut>) {
  const { registry } = ShortcutRegistry
  const shortcut = registry.getRegistry()[name]
  if (!shortcut) return
  registry.unregister(name)
  registry.register({ ...shortcut, ...how(shortcut) })
}

function keep(copied: unknown): boolean {
  writeSetting(place, copied)
  return true
}

/** What was copied last on this device; null where that was nothing, or nothing of ours. */
function kept(): CopyData | null {
  const data = readSetting<Partial<CopyData> | null>(place, null)
  return typeof data?.blockState?.type === 'string' ? (data as CopyData) : null
}

/** The workspace on which a copy is to stand: the one beside an open toolbox. */
const workspaceOf = (workspace: Blockly.WorkspaceSvg) => workspace.targetWorkspace ?? workspace

/** Gives Blockly what was copied. Is there anything? */
function take(workspace: Blockly.WorkspaceSvg): boolean {
  const data = kept()
  if (!data) return false
  const target = workspaceOf(workspace)
  clipboard.setLastCopiedData(belowAll(data, target))
  clipboard.setLastCopiedWorkspace(target)
  clipboard.setLastCopiedLocation(
    new Blockly.utils.Coordinate(data.blockState.x ?? 0, data.blockState.y ?? 0),
  )
  return true
}

/** Where no block is, a copy comes below all others. */
function belowAll(data: CopyData, workspace: Blockly.WorkspaceSvg): CopyData {
  const { left, bottom } = workspace.getBlocksBoundingBox()
  return Object.assign(data, { blockState: { ...data.blockState, x: left, y: bottom + 24 } })
}

/** Resolves when the workspace knows the blocks that were copied. */
async function taught(workspace: Blockly.WorkspaceSvg): Promise<void> {
  const data = kept()
  if (data && !isKnown(data.blockState)) await teachers.get(workspaceOf(workspace))?.()
}

/** Where the menu was opened; a menu that the keyboard has opened knows no place. */
async function paste(workspace: Blockly.WorkspaceSvg, opened: Event) {
  await taught(workspace)
  const data = kept()
  if (!data || !isKnown(data.blockState)) return
  const { Coordinate, svgMath } = Blockly.utils
  const at = opened instanceof PointerEvent && new Coordinate(opened.clientX, opened.clientY)
  clipboard.paste(
    belowAll(data, workspace),
    workspace,
    at ? svgMath.screenToWsCoordinates(workspace, at) : undefined,
  )
}

const isKnown = (state: State): boolean => state.type in Blockly.Blocks && inside(state).every(isKnown)

const inside = ({ inputs = {}, next }: State): readonly State[] =>
  [...Object.values(inputs), ...(next ? [next] : [])].flatMap(({ block, shadow }) =>
    [block, shadow].filter((one) => one !== undefined),
  )
