import { expect, test } from 'vitest'
import { stateOf } from './chip.ts'

const saved = (revision: number) => ({ state: 'saved', revision }) as const

test('a project that was just saved on the device is on its way until the class has this revision', () => {
  expect(stateOf(saved(3), { kind: 'class', revision: 2 }, null)).toBe('onItsWay')
  expect(stateOf(saved(3), { kind: 'waiting' }, null)).toBe('onItsWay')
  expect(stateOf(saved(3), { kind: 'class', revision: 3 }, null)).toBe('class')
})

test('a new project is on its way from its first save on; before any change nothing can be lost', () => {
  expect(stateOf(saved(1), undefined, null)).toBe('onItsWay')
  expect(stateOf(saved(0), undefined, null)).toBe('class')
})

test('while it is saved on the device it is on its way', () =>
  expect(stateOf({ state: 'saving', revision: 3 }, { kind: 'class', revision: 3 }, null)).toBe('onItsWay'))

test('a reason why the class does not have it comes first, and a failure of the device before that', () => {
  expect(stateOf(saved(3), { kind: 'class', revision: 3 }, 'away')).toBe('away')
  expect(stateOf(saved(3), { kind: 'conflict', revision: 4 }, 'away')).toBe('conflict')
  expect(stateOf(saved(3), { kind: 'refused', reason: 'tooBig' }, 'away')).toBe('refused')
  for (const state of ['failed', 'elsewhere', 'gone'] as const)
    expect(stateOf({ state, revision: 3 }, { kind: 'conflict', revision: 4 }, 'away')).toBeNull()
})
