import * as Blockly from 'blockly/core'
import type { Locale } from '#words/language.svelte.ts'
import { wordsIn } from '#words/message.ts'
import { rendererName } from './renderer.ts'
import { fontFor, themeFor } from './theme.ts'
import { toolboxPlugins, toolboxInfo } from './toolbox/info.ts'

const startScale = 0.76
/** For the last row of a class. */
const largeScale = 0.92

/** How blocks are drawn: clear letters, and large for a wall. */
export interface Looks {
  readonly letters: boolean
  readonly large: boolean
}

export const scaleOf = ({ large }: Looks): number => (large ? largeScale : startScale)

/** Draws blocks as large as they are now to be; its toolbox is as wide then. */
export function rescale(workspace: Blockly.WorkspaceSvg, looks: Looks): void {
  workspace.setScale(scaleOf(looks))
  workspace.getToolbox()?.position()
}

/** Resolves when blocks can be measured: Blockly asks once how wide its words are. */
export async function fontReady(letters: boolean): Promise<void> {
  await document.fonts.load(`700 16px ${fontFor(letters)}`)
}

export function options(locale: Locale, media: string, looks: Looks): Blockly.BlocklyOptions {
  return {
    toolbox: toolboxInfo(wordsIn(locale)),
    renderer: rendererName,
    theme: themeFor(looks.letters),
    media,
    plugins: toolboxPlugins,
    sounds: false,
    trashcan: false,
    grid: { spacing: 29, length: 3, colour: '#E6D6BA', snap: false },
    move: { scrollbars: true, drag: true, wheel: true },
    zoom: {
      controls: false,
      wheel: false,
      pinch: true,
      startScale: scaleOf(looks),
      minScale: 0.4,
      maxScale: 2,
      scaleSpeed: 1.2,
    },
  }
}

/** Clear letters stand 2 % apart; Blockly measures words on a canvas that has to know. */
export function spaceLetters(letters: boolean) {
  const canvas = document.querySelector<HTMLCanvasElement>('canvas.blocklyComputeCanvas')
  const context = canvas?.getContext('2d')
  if (context) context.letterSpacing = letters ? '0.32px' : '0px'
}
