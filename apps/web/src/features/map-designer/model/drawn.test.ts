import 'fake-indexeddb/auto'
import { isMap, type RoadMap } from '@botgarten/programs'
import fc from 'fast-check'
import { afterEach, beforeAll, beforeEach, describe, expect, test } from 'vitest'
import { load } from '#storage/projects.ts'
import { fillDisk, freshDevice } from '#storage/testing/device.ts'
import { DrawnMap } from './drawn.svelte.ts'
import type { OpenedDrawing } from './projects.ts'
import { openedWith, row } from './testing/opened.ts'

let opened: OpenedDrawing
beforeAll(async () => {
  opened = await openedWith(row)
})
beforeEach(freshDevice)
const open: DrawnMap<RoadMap>[] = []
afterEach(() => {
  for (const map of open.splice(0)) map.close()
})

function begun(of = opened): DrawnMap<RoadMap> {
  const map = new DrawnMap(of, of.project.maps![of.mapId] as RoadMap)
  open.push(map)
  return map
}
const named = (name: string): RoadMap => ({ ...row, name })

describe('undo and redo', () => {
  const actions = fc.array(
    fc.oneof(fc.constantFrom('undo', 'redo'), fc.integer({ min: 0, max: 5 }).map(String)),
    { maxLength: 40 },
  )

  test('go through all versions as a naive list of them does', () => {
    fc.assert(
      fc.property(actions, (all) => {
        const map = begun()
        let [versions, at] = [[map.settled.name], 0]
        for (const action of all) {
          if (action === 'undo') at = Math.max(0, at - 1)
          else if (action === 'redo') at = Math.min(versions.length - 1, at + 1)
          else [versions, at] = [[...versions.slice(0, at + 1), action], at + 1]
          if (action === 'undo' || action === 'redo') map[action]()
          else map.change(named(action))
          expect(map.settled.name).toBe(versions[at])
          expect([map.canUndo, map.canRedo]).toEqual([at > 0, at < versions.length - 1])
        }
        map.close()
      }),
    )
  })

  test('what changes nothing is no step', () => {
    const map = begun()
    map.change(map.settled)
    expect(map.canUndo).toBe(false)
  })

  test('200 steps can be undone, and no more', () => {
    const map = begun()
    for (let step = 1; step <= 205; step += 1) map.change(named(String(step)))
    let undone = 0
    for (; map.canUndo; undone += 1) map.undo()
    expect([undone, map.settled.name]).toEqual([200, '5'])
  })
})

describe('a project', () => {
  test('that holds nothing but the map is named like it, as long as it has a name', () => {
    const map = begun()
    map.rename('  Forest ')
    expect([map.settled.name, map.project.name]).toEqual(['  Forest ', 'Forest'])
    map.rename('   ')
    expect(map.project.name).toBe('Mine')
  })

  test('of a card, or with another map, keeps its own name', () => {
    const { project } = opened
    const ofCard = begun({ ...opened, project: { ...project, card: 'railway' } })
    const withTwo = begun({ ...opened, project: { ...project, maps: { ...project.maps, other: row } } })
    for (const map of [ofCard, withTwo]) {
      map.rename('Forest')
      expect(map.project.name).toBe('Mine')
      expect(map.project.maps!['map']!.name).toBe('Forest')
    }
  })

  test('is saved after every step', async () => {
    const map = begun()
    map.rename('Forest')
    map.undo()
    map.redo()
    await map.autosave.flush()
    expect((await load('mine'))?.project).toEqual(map.project)
    expect(isMap(map.project.maps!['map'])).toBe(true)
  })
})

describe('learning on the map', () => {
  test('is saved with the project before anybody goes there', async () => {
    const map = begun()
    expect(await map.learnHere()).toBe(true)
    expect((await load('mine'))?.project).toEqual(map.learning)
  })

  test('shows a message if it cannot be saved', async () => {
    const map = begun()
    const makeRoom = fillDisk()
    expect(await map.learnHere()).toBe(false)
    makeRoom()
  })
})
