import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { printable } from './fit.ts'

let page: EventTarget
beforeEach(() => {
  page = new EventTarget()
  vi.stubGlobal('window', page)
})
afterEach(() => vi.unstubAllGlobals())

/** A page of materials without anything that would have to be fitted. */
function article(dataset: { readonly paper?: string; readonly kind?: string }) {
  const classes = new Set<string>()
  const classList = {
    add: (...names: readonly string[]) => names.forEach((name) => classes.add(name)),
    remove: (...names: readonly string[]) => names.forEach((name) => classes.delete(name)),
  }
  const element = { dataset, classList, querySelectorAll: () => [] } as unknown as HTMLElement
  return { classes, end: printable(element) }
}

test.each([
  [{ kind: 'sheet' }, ['paper', 'by-hand', 'sheet']],
  [{ paper: 'a4', kind: 'card' }, ['paper', 'by-hand', 'sheet', 'card']],
  [{ paper: 'a4', kind: 'plan' }, ['paper', 'by-hand', 'plan']],
  [{ paper: 'a5', kind: 'card' }, ['paper', 'by-hand', 'cards-a5', 'card']],
  [{ paper: 'slides', kind: 'deck' }, ['paper', 'by-hand', 'deck']],
])('%j has the layout of paper while it is printed, and its own before and after', (dataset, expected) => {
  const { classes, end } = article(dataset)
  expect([...classes]).toEqual([])
  page.dispatchEvent(new Event('beforeprint'))
  expect([...classes].toSorted()).toEqual(expected.toSorted())
  page.dispatchEvent(new Event('afterprint'))
  expect([...classes]).toEqual([])
  end()
  page.dispatchEvent(new Event('beforeprint'))
  expect([...classes]).toEqual([])
})
