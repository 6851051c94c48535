/**
 * Gives an element the focus that has none by itself: a heading, a part of the page. Tab goes on from there. A dialog that is
 * about to open around it begins with it too.
 */
export function focusOn(element: HTMLElement) {
  if (!element.hasAttribute('tabindex')) element.tabIndex = -1
  element.autofocus = true
  element.focus()
}

/** Where a page begins: its visible heading, else its content. */
export function focusPage() {
  const main = document.querySelector('main')
  const start = main?.querySelector<HTMLElement>('h1:not(.for-ears-only)') ?? main
  if (start) focusOn(start)
}

/** What a skip link leads to: the content, past its heading. */
export function focusMain() {
  const main = document.querySelector('main')
  if (main) focusOn(main)
}
