import { afterEach, expect, test, vi } from 'vitest'
import { isTyping, undoKey } from './keys.ts'

afterEach(() => vi.unstubAllGlobals())

const press = (key: string, ...held: readonly ('ctrlKey' | 'metaKey' | 'shiftKey' | 'altKey')[]) =>
  undoKey({
    ...{ key, ctrlKey: false, metaKey: false, shiftKey: false, altKey: false },
    ...Object.fromEntries(held.map((name) => [name, true])),
  })

test('Z takes back with Ctrl, on a Mac with Cmd', () => {
  expect(press('z', 'ctrlKey')).toBe('undo')
  expect(press('z', 'metaKey')).toBe('undo')
  expect(press('Z', 'ctrlKey')).toBe('undo')
})

test('Shift and Z, or Y, goes on again', () => {
  expect(press('Z', 'ctrlKey', 'shiftKey')).toBe('redo')
  expect(press('y', 'ctrlKey')).toBe('redo')
})

test('letters alone, and what belongs to the browser, do nothing', () => {
  expect(press('z')).toBeNull()
  expect(press('z', 'ctrlKey', 'altKey')).toBeNull()
  expect(press('z', 'ctrlKey', 'metaKey')).toBeNull()
  expect(press('a', 'ctrlKey')).toBeNull()
  expect(press('Y', 'ctrlKey', 'shiftKey')).toBeNull()
})

test('who writes in a field, or reads a dialog, keeps its keys', () => {
  class Element extends EventTarget {
    readonly #inside: string
    constructor(inside: string) {
      super()
      this.#inside = inside
    }
    closest = (selector: string) => (selector.split(', ').includes(this.#inside) ? this : null)
  }
  vi.stubGlobal('Element', Element)
  for (const inside of ['input', 'textarea', 'dialog']) expect(isTyping(new Element(inside))).toBe(true)
  expect(isTyping(new Element('button'))).toBe(false)
  expect(isTyping(new EventTarget())).toBe(false)
  expect(isTyping(null)).toBe(false)
})
