import * as Blockly from 'blockly/core'
import { categoryColours, darker, layerGround, roadsGround, paper, unknownColour } from './colours.ts'

const plain = 'Nunito, sans-serif'
const clear = "'Atkinson Hyperlegible Next', sans-serif"

/** The font of the blocks. `letters`: the one whose letters are hard to mix up. */
export const fontFor = (letters: boolean): string => (letters ? clear : plain)

/** Fields stand 18 % darker on the block, outlines 26 % (visual.md 2). */
function style(colour: string): Blockly.Theme.BlockStyle {
  return {
    colourPrimary: colour,
    colourSecondary: darker(colour, 0.18),
    colourTertiary: darker(colour, 0.26),
    hat: '',
  }
}

const colours = { ...categoryColours, layer: layerGround, roads: roadsGround, unknown: unknownColour }

/** Two fonts, else equal: the name tells Blockly's styles apart. */
function define(name: string, letters: boolean): Blockly.Theme {
  return Blockly.Theme.defineTheme(name, {
    name,
    blockStyles: Object.fromEntries(Object.entries(colours).map(([name, colour]) => [name, style(colour)])),
    categoryStyles: Object.fromEntries(Object.entries(colours).map(([name, colour]) => [name, { colour }])),
    componentStyles: {
      workspaceBackgroundColour: paper,
      toolboxBackgroundColour: 'transparent',
      toolboxForegroundColour: '#3A2A20',
      flyoutBackgroundColour: '#FBF5EA',
      flyoutForegroundColour: '#3A2A20',
      flyoutOpacity: 1,
      scrollbarColour: '#DCC7A5',
      scrollbarOpacity: 1,
      insertionMarkerColour: '#4A3428',
      insertionMarkerOpacity: 0.25,
      selectedGlowColour: '#FFC83D',
    },
    // 12 pt = 16 px at scale 1.
    fontStyle: { family: fontFor(letters), weight: '700', size: 12 },
  })
}

const themes = { plain: define('botgarten', false), clear: define('botgarten-clear', true) }

export const themeFor = (letters: boolean): Blockly.Theme => (letters ? themes.clear : themes.plain)
