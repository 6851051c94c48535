import * as Blockly from 'blockly/core'
import { definitions } from '@botgarten/blocks'
import { blocklyWordsIn } from './blockly-words.ts'
import { usePlainIds } from '../model/ids.ts'
import { keepFocus } from './keep-focus.ts'
import { setUpMenus } from './menus.ts'
import { defineBlocks } from './shape.ts'
import { registerToolbox } from './toolbox/info.ts'
import type { Locale } from '#words/language.svelte.ts'
import { wordsIn, type Words } from '#words/message.ts'

let ready = false

/** Brings Blockly's one global registry into the shape this editor needs; only the first call does something. */
export function setUp(): void {
  if (ready) return
  ready = true
  usePlainIds()
  Blockly.Scrollbar.scrollbarThickness = 8
  registerToolbox()
  setUpMenus()
  leaveUndoToThePage()
  nameKeys()
  nameFieldsWhenDrawn()
  keepFocus()
}

/** Blocks and Blockly's own words in a language. What is on a workspace already keeps its old words. */
export function speak(locale: Locale): void {
  Blockly.setLocale({ ...blocklyWordsIn(locale) })
  defineBlocks(Object.values(definitions), { words: wordsIn(locale), locale })
}

/** Blockly names the keys of its hints once, before it has been told a language. */
function nameKeys() {
  const show = Blockly.Toast.show.bind(Blockly.Toast)
  const { Msg } = Blockly
  const named = (text: string) =>
    text.replace(/\b(Control|Shift)(?= \+ )/g, (key) => Msg[`${key.toUpperCase()}_KEY`] ?? key)
  Blockly.Toast.show = (workspace, options) =>
    show(workspace, { ...options, message: named(options.message) })
}

/** One stack of undo holds blocks, world and weights: the page decides what Ctrl+Z undoes. */
function leaveUndoToThePage() {
  const { registry } = Blockly.ShortcutRegistry
  for (const name of ['undo', 'redo']) registry.unregister(name)
}

/** Blockly asks a field for its name before it is drawn, and is answered with an error each time: thousands in a large file. */
function nameFieldsWhenDrawn() {
  const { prototype } = Blockly.Field
  // oxlint-disable-next-line typescript/unbound-method -- it is called with the field below
  const name = prototype.recomputeAriaContext
  prototype.recomputeAriaContext = function () {
    return this.getSvgRoot() !== null && name.call(this)
  }
}

/** Blockly leaves its frame and its toolbox without names, and counts only what it saw coming. */
export function nameParts(workspace: Blockly.WorkspaceSvg, words: Words): void {
  const frame = workspace.getInjectionDiv()
  frame.setAttribute('aria-label', words('editor.blocks'))
  frame.querySelector('.blocklyToolbox [role=tree]')?.setAttribute('aria-label', words('editor.toolbox'))
  workspace.setInitialAriaContext()
  // Blockly measures words on a canvas at the end of the body; it shows nothing.
  document.querySelector('.blocklyComputeCanvas')?.setAttribute('aria-hidden', 'true')
}
