import type { Page } from '@playwright/test'

/** Px between the border of a dialog and the words or controls in it, at least. */
const nearest = 6

/** Words and controls that touch the border of the open dialog, a sentence each. Parts that scroll are checked at the sides only. */
export const atBorder = (page: Page): Promise<string[]> =>
  page.evaluate((nearest) => {
    const dialog = document.querySelector<HTMLElement>('dialog[open]:not(.full)')
    if (!dialog) return []
    const { left, top, bottom } = dialog.getBoundingClientRect()
    const inner = {
      left: left + dialog.clientLeft,
      right: left + dialog.clientLeft + dialog.clientWidth,
      top: top + dialog.clientTop - dialog.scrollTop,
      bottom: Math.max(bottom, top + dialog.clientTop - dialog.scrollTop + dialog.scrollHeight),
    }
    /** Is there a box between the element and the dialog that scrolls what does not fit? */
    const scrolls = (element: Element) => {
      for (let box = element.parentElement; box && box !== dialog; box = box.parentElement)
        if (/auto|scroll|hidden/.test(getComputedStyle(box).overflowY)) return true
      return false
    }
    const isHeard = (element: Element) => element.closest('.for-ears-only') !== null
    const boxes: (readonly [Element, string, DOMRect])[] = []
    for (const control of dialog.querySelectorAll('button, input, select, textarea, a[href]'))
      if (control.checkVisibility({ visibilityProperty: true, opacityProperty: true }) && !isHeard(control))
        boxes.push([control, control.ariaLabel ?? control.textContent, control.getBoundingClientRect()])
    const texts = document.createTreeWalker(dialog, NodeFilter.SHOW_TEXT)
    const range = document.createRange()
    while (texts.nextNode()) {
      const { parentElement, textContent } = texts.currentNode
      if (!parentElement?.checkVisibility({ visibilityProperty: true }) || !textContent?.trim()) continue
      if (isHeard(parentElement)) continue
      range.selectNodeContents(texts.currentNode)
      for (const line of range.getClientRects()) boxes.push([parentElement, textContent, line])
    }
    const faults = boxes.flatMap(([element, words, box]) => {
      if (box.width <= 1 || box.height <= 1) return []
      const upright = scrolls(element) ? [] : [box.top - inner.top, inner.bottom - box.bottom]
      const gap = Math.min(box.left - inner.left, inner.right - box.right, ...upright)
      return gap < nearest ? [`“${words.trim().slice(0, 40)}” is ${gap.toFixed(0)} px from the border`] : []
    })
    return [...new Set(faults)]
  }, nearest)
