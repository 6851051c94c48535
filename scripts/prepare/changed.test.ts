import { existsSync } from 'node:fs'
import { describe, expect, it } from 'vitest'
import { roomOf, specs, specsOf } from './changed.mjs'
import { inHouse } from './house.mjs'

const folders = ['apps/web/src/features', 'apps/web/src', 'packages', 'apps', '.']

describe('files with browser tests', () => {
  it.each(specs())('$file names in its first line rooms that are there', ({ rooms }) => {
    expect(rooms.length).toBeGreaterThan(0)
    const missing = rooms.filter((room) => !folders.some((folder) => existsSync(inHouse(folder, room))))
    expect(missing).toEqual([])
  })
})

describe('what has changed', () => {
  it.each([
    ['apps/web/src/features/sorting/desk.svelte.ts', 'sorting'],
    ['apps/web/src/features/q-learning/view/Table.svelte', 'q-learning'],
    ['apps/web/src/storage/bin.ts', 'storage'],
    ['packages/simulation/step.ts', 'simulation'],
    ['apps/cli/run.ts', 'cli'],
    // eslint-disable-next-line no-restricted-syntax -- a name; nothing is read
    ['content/cards/network/06-fear/card.json', 'content'],
    ['scripts/prepare/run.mjs', 'scripts'],
    ['README.md', null],
  ])('%s is in the room %s', (file, room) => expect(roomOf(file)).toBe(room))

  const all = [
    { file: 'e2e/tests/sorting.spec.ts', rooms: ['sorting'] },
    { file: 'e2e/tests/cards.spec.ts', rooms: ['content', 'network'] },
  ]

  it('leads to the browser tests of its room', () => {
    expect(specsOf(['apps/web/src/features/sorting/hull.ts'], all)).toEqual(['e2e/tests/sorting.spec.ts'])
    // eslint-disable-next-line no-restricted-syntax -- a name; nothing is read
    expect(specsOf(['content/worlds/maze/world.json'], all)).toEqual(['e2e/tests/cards.spec.ts'])
  })

  it('leads to a browser test that has changed itself, and to none where only a unit test has', () => {
    expect(specsOf(['e2e/tests/cards.spec.ts'], all)).toEqual(['e2e/tests/cards.spec.ts'])
    expect(specsOf(['apps/web/src/features/sorting/hull.test.ts'], all)).toEqual([])
  })
})
