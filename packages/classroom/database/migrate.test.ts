import { expect, test } from 'vitest'
import { migrations } from './migrate.ts'

test.each(['sqlite', 'postgres'] as const)(
  'the steps of a %s database are in the order of their names, in which they are taken',
  (kind) => {
    const names = Object.keys(migrations({ kind }))
    expect(names).toEqual(names.toSorted())
  },
)
