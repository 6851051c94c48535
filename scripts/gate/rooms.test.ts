import { existsSync } from 'node:fs'
import { describe, expect, it } from 'vitest'
import { inHouse as inRepo } from '../prepare/house.mjs'
import { listSpecs, specsOf } from './rooms.mjs'

const folders = ['apps/web/src/features', 'apps/web/src', 'packages', 'apps', '.']

describe('files with browser tests', () => {
  it.each(listSpecs())('$file names rooms that exist in its first line', ({ rooms }) => {
    expect(rooms.length).toBeGreaterThan(0)
    const missing = rooms.filter((room) => !folders.some((folder) => existsSync(inRepo(folder, room))))
    expect(missing).toEqual([])
  })

  it('are found by the rooms that they name, all of them where no room is named', () => {
    const specs = [
      { file: 'e2e/tests/sorting.spec.ts', rooms: ['sorting'] },
      { file: 'e2e/tests/cards.spec.ts', rooms: ['content', 'network'] },
    ]
    expect(specsOf(['network', 'sorting'], specs)).toEqual([
      'e2e/tests/sorting.spec.ts',
      'e2e/tests/cards.spec.ts',
    ])
    expect(specsOf(['network'], specs)).toEqual(['e2e/tests/cards.spec.ts'])
    expect(specsOf([], specs)).toHaveLength(2)
  })
})
