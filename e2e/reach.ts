import type { Page } from '@playwright/test'

/**
 * What cannot be reached or read at the size the window has now, each as a sentence for whoever mends it: a control that
 * stays outside of the window or under something else however one scrolls, words that something lies on, a page or a part
 * that has to be scrolled in both directions, and a menu that cuts its words. Blockly's own DOM, and what lies on the
 * world's floor, are stages of their own.
 */
export const outOfReach = (page: Page): Promise<string[]> =>
  page.evaluate(() => {
    const stage = '.injectionDiv, .blocklyWidgetDiv, .blocklyDropDownDiv, .camera, .plane'
    const faults = new Set<string>()
    const nameOf = (element: Element) => {
      const words = element.getAttribute('aria-label') ?? element.textContent?.trim().replace(/\s+/g, ' ')
      return `${element.tagName.toLowerCase()}.${[...element.classList].filter((c) => !c.startsWith('svelte-')).join('.')} “${(words ?? '').slice(0, 40)}”`
    }
    /** What is asked of every box above every word is found out once. */
    const once = <Found>(find: (element: Element) => Found) => {
      const found = new Map<Element, Found>()
      return (element: Element): Found => {
        if (!found.has(element)) found.set(element, find(element))
        return found.get(element)!
      }
    }
    /** Only for ears. */
    const isUnseen: (element: Element) => boolean = once(
      (element) =>
        getComputedStyle(element).clipPath === 'inset(50%)' ||
        (element.parentElement !== null && isUnseen(element.parentElement)),
    )
    const overflowOf = once((element) => {
      const { overflowX, overflowY } = getComputedStyle(element)
      return { overflowX, overflowY }
    })
    const shows = (element: Element) =>
      element.checkVisibility({ visibilityProperty: true, contentVisibilityAuto: true }) &&
      element.getBoundingClientRect().width > 1 &&
      !element.closest('[inert], .for-ears-only') &&
      !element.closest(stage) &&
      !isUnseen(element)
    // What is open lies over the rest, as it should.
    const topmost =
      document.querySelector('dialog[open]') ?? document.querySelector('.menu > .sheet') ?? document.body
    const belong = (one: Element, other: Element) =>
      one.contains(other) || other.contains(one) || (other.closest('label')?.contains(one) ?? false)
    const inBox = (element: Element, x: number, y: number) =>
      [...element.getClientRects()].some((r) => x >= r.left && x <= r.right && y >= r.top && y <= r.bottom)

    /** Things that only look cut: what a person cannot scroll must not have been scrolled to show this. */
    function stuck(element: Element): Element | null {
      for (let box = element.parentElement; box && box !== document.body; box = box.parentElement) {
        const { overflowX, overflowY } = overflowOf(box)
        if (
          (overflowY === 'hidden' && box.scrollTop > 1) ||
          (overflowX === 'hidden' && Math.abs(box.scrollLeft) > 1)
        ) {
          box.scrollTo({ top: 0, left: 0, behavior: 'instant' })
          return box
        }
      }
      return null
    }

    const controls = [
      ...topmost.querySelectorAll('a[href], button, input, select, textarea, summary, [tabindex="0"]'),
    ].filter(shows)
    for (const control of controls) {
      control.scrollIntoView({ block: 'center', inline: 'center', behavior: 'instant' })
      const box = stuck(control)
      if (box) faults.add(`${nameOf(control)} is cut off by ${nameOf(box)}`)
      const target = control.getBoundingClientRect()
      const [x, y] = [target.left + target.width / 2, target.top + target.height / 2]
      if (target.left < -1 || target.right > innerWidth + 1 || y < 0 || y > innerHeight) {
        // What is larger than the window is reached where it begins.
        if (target.width <= innerWidth && target.height <= innerHeight)
          faults.add(`${nameOf(control)} is outside of the window`)
        continue
      }
      const hit = document.elementFromPoint(x, y)
      if (hit && !belong(hit, control)) faults.add(`${nameOf(hit)} lies on ${nameOf(control)}`)
    }

    const texts = document.createTreeWalker(topmost, NodeFilter.SHOW_TEXT)
    const range = document.createRange()
    while (texts.nextNode()) {
      const element = texts.currentNode.parentElement
      if (!element || !texts.currentNode.textContent?.trim() || !shows(element) || element.closest('svg'))
        continue
      if (getComputedStyle(element).pointerEvents === 'none') continue
      range.selectNodeContents(texts.currentNode)
      element.scrollIntoView({ block: 'center', inline: 'center', behavior: 'instant' })
      stuck(element)
      const lines = range.getClientRects()
      const line = lines[Math.floor(lines.length / 2)]
      if (!line || line.width <= 1) continue
      const [x, y] = [line.left + line.width / 2, line.top + line.height / 2]
      const hit = document.elementFromPoint(x, y)
      if (hit && !belong(hit, element) && inBox(hit, x, y))
        faults.add(`${nameOf(hit)} lies on the words ${nameOf(element)}`)
    }

    const page = document.scrollingElement!
    if (page.scrollWidth > page.clientWidth)
      faults.add(`the page is ${page.scrollWidth - page.clientWidth} px too wide`)
    const scrolls = (how: string) => how === 'auto' || how === 'scroll'
    for (const box of document.querySelectorAll('*')) {
      const wider = box.scrollWidth > box.clientWidth + 1
      if (!wider || box === page || !shows(box)) continue
      const { overflowX, overflowY } = overflowOf(box)
      if (scrolls(overflowX) && scrolls(overflowY) && box.scrollHeight > box.clientHeight + 1)
        faults.add(`${nameOf(box)} scrolls in both directions`)
      if (box.matches('.menu > .sheet')) faults.add(`${nameOf(box)} cuts its words`)
    }
    for (const box of document.querySelectorAll('*'))
      if (box.scrollTop || box.scrollLeft) box.scrollTo({ top: 0, left: 0, behavior: 'instant' })
    return [...faults]
  })
