import * as Blockly from 'blockly/core'

/**
 * Keeps the focus where the keyboard is. In the frame after a block or a field got the focus, Blockly moves its
 * neighbours in the page so that it lies in front, and a browser takes the focus from what is moved: whoever had gone on
 * to one of them meanwhile would stand nowhere, and the next key would be lost.
 */
export function keepFocus(): void {
  const { prototype } = Blockly.BlockSvg
  // oxlint-disable-next-line typescript/unbound-method -- it is called with the block below
  const move = prototype.moveSvgRootToFront
  prototype.moveSvgRootToFront = function (blockOnly) {
    let focused: Element | null = null
    // Three of one frame, in this order: Blockly's own is the second.
    requestAnimationFrame(() => (focused = document.activeElement))
    move.call(this, blockOnly)
    requestAnimationFrame(() => {
      if (focused instanceof SVGElement && focused.isConnected && document.activeElement === document.body)
        focused.focus({ preventScroll: true })
    })
  }
}
