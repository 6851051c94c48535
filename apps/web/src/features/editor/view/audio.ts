import * as Blockly from 'blockly/core'

interface Audio {
  context?: AudioContext | undefined
  dispose(): void
}

const isDrawn = (workspace: Blockly.Workspace) => workspace instanceof Blockly.WorkspaceSvg
/** Its context is its own matter. */
const audioOf = (workspace: Blockly.WorkspaceSvg) => workspace.getAudioManager() as unknown as Audio

/** Opens the way to the loudspeaker when something is to be heard. */
function openLate(audio: Audio): void {
  let context: AudioContext | undefined
  Object.defineProperty(audio, 'context', { configurable: true, get: () => (context ??= new AudioContext()) })
  audio.dispose = () => void context?.close()
}

/**
 * Puts blocks onto a page. For each workspace Blockly opens a way to the loudspeaker before it draws anything, which takes
 * longer than all the drawing: it is opened with the first sound.
 */
export function inject(host: Element, options: Blockly.BlocklyOptions): Blockly.WorkspaceSvg {
  const { AudioContext } = window
  Reflect.set(window, 'AudioContext', undefined)
  try {
    const before = new Set(Blockly.common.getAllWorkspaces())
    const workspace = Blockly.inject(host, options)
    // That of the toolbox is another one.
    const all = Blockly.common.getAllWorkspaces().filter((one) => !before.has(one))
    if (AudioContext as unknown) all.filter(isDrawn).forEach((one) => openLate(audioOf(one)))
    return workspace
  } finally {
    Reflect.set(window, 'AudioContext', AudioContext)
  }
}
