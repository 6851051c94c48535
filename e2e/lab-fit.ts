import type { Page } from '@playwright/test'

/** What of a lab's screen does not fit, and how large Bo is. */
export interface Fit {
  /** Px from wheel to wheel, with the wheels; null where the floor is a small picture beside a map. */
  readonly bo: number | null
  /** Names of buttons that lie over a block, or over the list of blocks. */
  readonly over: readonly string[]
  /** Px by which blocks are cut off at the right. */
  readonly cut: number
  /** Px by which the network is higher than its place. */
  readonly pans: number
}

/** Bo's track is 18 cm wide, Bo 21.5. */
const widthByTrack = 21.5 / 18

export const fitOf = async (page: Page): Promise<Fit> => {
  const { track, ...fit } = await page.evaluate(() => {
    const boxOf = (element: Element) => element.getBoundingClientRect()
    const meet = (a: DOMRect, b: DOMRect) =>
      a.left < b.right - 1 && b.left < a.right - 1 && a.top < b.bottom - 1 && b.top < a.bottom - 1
    const shown = (element: Element) => element.checkVisibility({ visibilityProperty: true })
    const paper = document.querySelector('.program:not([hidden]) .blocklyMainBackground')
    const edge = paper ? boxOf(paper) : new DOMRect()
    const seen = ({ left, top, right, bottom }: DOMRect) => {
      const [x, y] = [Math.max(left, edge.left), Math.max(top, edge.top)]
      return new DOMRect(
        x,
        y,
        Math.max(0, Math.min(right, edge.right) - x),
        Math.max(0, Math.min(bottom, edge.bottom) - y),
      )
    }
    const paths = document.querySelectorAll('.program:not([hidden]) .blocklyBlockCanvas .blocklyPath')
    const blocks = [...paths].filter((path) => !path.closest('.blocklyFlyout')).map(boxOf)
    const lists = [...document.querySelectorAll('.blocklyToolboxCategoryContainer')].filter(shown).map(boxOf)
    const program = document.querySelector('section.program')
    const buttons = [...(program?.querySelectorAll('button') ?? [])].filter(
      (button) => shown(button) && !button.closest('.editor'),
    )
    const covered = [...blocks.map(seen).filter(({ width, height }) => width * height > 0), ...lists]
    const [left, right] = ['bo motor C', 'bo motor B'].map((name) =>
      globalThis.botgarten?.places().find((place) => place.name === name),
    )
    const nets = [...document.querySelectorAll('.network-pane .stage')].map((stage) => stage.parentElement!)
    return {
      track: left && right ? Math.hypot(left.x - right.x, left.y - right.y) : null,
      over: buttons
        .filter((button) => covered.some((block) => meet(block, boxOf(button))))
        .map((button) => button.getAttribute('aria-label') ?? button.textContent.trim()),
      cut: Math.max(0, ...blocks.map((block) => block.right - edge.right)),
      pans: Math.max(0, ...nets.map(({ scrollHeight, clientHeight }) => scrollHeight - clientHeight)),
    }
  })
  return { ...fit, bo: track === null ? null : track * widthByTrack }
}
