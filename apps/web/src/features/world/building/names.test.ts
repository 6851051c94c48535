import type { Item } from './edits.ts'
import { expect, test } from 'vitest'
import { message } from '#words/message.ts'
import { nameOf } from './names.ts'

const named = (kind: 'areas' | 'lines') => nameOf({ kind, thing: { id: 'x' } } as unknown as Item)

test('an area is called an area, and a line a line', () => {
  expect(named('areas')).toBe(message('build.area'))
  expect(named('lines')).toBe(message('build.line'))
  expect(named('areas')).not.toBe(named('lines'))
})
