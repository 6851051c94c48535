// Drawings of a page that a screen reader leaves out, as lines: elements with their classes and attribute names.
import type { Page } from '@playwright/test'

/** Counts the elements of each kind. Values of attributes are left out, but an empty value is marked. */
export const drawnIn = (page: Page, parts: string): Promise<readonly string[]> =>
  page.evaluate((selector) => {
    /** They have few values, which differ between states. */
    const told = ['tabindex', 'visibility', 'data-phase', 'data-closed', 'width', 'height']
    const looksOf = (one: Element) =>
      [...one.classList].filter((name) => !name.startsWith('svelte-')).map((name) => `.${name}`)
    const attributesOf = (one: Element) =>
      [...one.attributes]
        .filter(({ name }) => !/^(class|style|aria-.*|role|type|title|id|viewBox|xmlns)$/.test(name))
        .map(({ name, value }) =>
          value === '' ? `no ${name}` : told.includes(name) ? `${name} ${value}` : name,
        )
    const counts = new Map<string, number>()
    for (const one of document.querySelectorAll(selector)) {
      if (!one.checkVisibility()) continue
      const attributes = attributesOf(one).toSorted().join(', ')
      const isField = one instanceof HTMLSelectElement || one instanceof HTMLInputElement
      const text = isField ? `= ${one.value}` : one.childElementCount === 0 ? one.textContent.trim() : ''
      const line = `~ ${one.tagName.toLowerCase()}${looksOf(one).join('')} (${attributes}) ${text}`.trim()
      counts.set(line, (counts.get(line) ?? 0) + 1)
    }
    return [...counts].map(([line, count]) => `${line} × ${count}`).toSorted()
  }, parts)
