import { content } from '@botgarten/content/files'
import { expect, test } from 'vitest'
import { friendship } from '#storage/testing/sample.ts'
import { backFrom, type Change } from './change.ts'
import type { RunningLab } from './running.svelte.ts'

const { world, programs, brains } = friendship
const table = content.program('try-dodge', 'solution')!.tables!['try']!
const backWith = (change: Change, tables?: RunningLab['document']['tables']) =>
  backFrom(change, {
    document: { world, programs, brains, ...(tables && { tables }) },
    view: { robots: [], obstacles: [] } as unknown as RunningLab['view'],
  })

test('a table of learned values that is replaced or deleted comes back with undo, and a first one goes', () => {
  const deleted = { kind: 'table', id: 'try', after: null } as const
  expect(backWith(deleted, { try: table })).toEqual({ ...deleted, after: table })
  const first = { kind: 'table', id: 'try', after: table } as const
  expect(backWith(first)).toEqual(deleted)
  expect(backWith(first, { other: table })).toEqual(deleted)
})
