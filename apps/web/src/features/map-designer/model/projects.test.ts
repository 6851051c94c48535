import 'fake-indexeddb/auto'
import { addBlocks } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { emptyRooms, writeMap } from '@botgarten/maps/own'
import { learningIn, stationsOf, type Project } from '@botgarten/programs'
import { afterEach, beforeAll, beforeEach, describe, expect, test, vi } from 'vitest'
import { newProject } from '#content/new-project.ts'
import { assetsFromDisk } from '#lab/testing/assets.ts'
import { load, save } from '#storage/projects.ts'
import { fillDisk, freshDevice } from '#storage/testing/device.ts'
import { friendship } from '#storage/testing/sample.ts'
import maps from 'content:maps'
import {
  begin,
  learnOnGiven,
  learningOn,
  openDrawing,
  openMapOf,
  ownMaps,
  startFrom,
  withMap,
} from './projects.ts'
import { drawn, openedWith, row } from './testing/opened.ts'

beforeAll(() => addBlocks(learning))
beforeEach(async () => {
  await freshDevice()
  assetsFromDisk()
})
afterEach(() => void vi.unstubAllGlobals())

const outlineOf = ({ programs }: Project) => Object.values(programs).map(learningIn)[0]

describe('a project that begins with a map', () => {
  test('is saved, learns on the map from its start to its goal, and is found in the list', async () => {
    const query = (await begin({ ...row, start: 2, goals: [0, 1] }))!
    const id = new URLSearchParams(query).get('p')!
    const { project } = (await load(id))!
    expect(new URLSearchParams(query).get('m')).toBe('map')
    expect(outlineOf(project)).toMatchObject({ map: 'own:map', start: 2, goal: 0 })
    expect(project).toMatchObject({ name: 'Pond', botgarten: 2 })
    expect(await ownMaps()).toEqual([{ id, mapId: 'map', map: { ...row, start: 2, goals: [0, 1] } }])
  })

  test('learns at once on each world of rooms, from its start to its goal', async () => {
    const grids = maps.maps.filter((id) => !maps.drawn.includes(id))
    expect(grids).toEqual(expect.arrayContaining(['cliff', 'lake', 'windy', 'errand']))
    for (const map of grids) {
      const { project } = (await load((await learnOnGiven(map, 'World'))!.id))!
      const [start, goal] = maps.ends[map]!
      expect(outlineOf(project)).toMatchObject({ map, start, goal, closed: [] })
    }
    const makeRoom = fillDisk()
    expect(await learnOnGiven('lake', 'World')).toBeNull()
    makeRoom()
  })

  test('is none where the device has no room', async () => {
    const makeRoom = fillDisk()
    expect(await begin(row)).toBeNull()
    makeRoom()
  })

  test('learns on rooms from the start to the treasure', async () => {
    const id = new URLSearchParams((await begin(emptyRooms('Rooms', 3, 2)))!).get('p')!
    expect(outlineOf((await load(id))!.project)).toMatchObject({ map: 'own:map', start: 0, goal: 5 })
  })
})

describe('programs that learn on a map', () => {
  test('have 20 tries for each station, and 100 at least', async () => {
    const triesOn = async (count: number) => {
      const map = drawn(Array.from({ length: count }, (_, k) => [100 + 200 * k, 500] as const))
      const { project } = await openedWith(map)
      const { programs } = await newProject('Mine', 'railway')
      const text = JSON.stringify(learningOn({ ...project, programs }, 'map').programs)
      return /"EPISODES":"(\d+)"/.exec(text)?.[1]
    }
    expect([await triesOn(3), await triesOn(5), await triesOn(6)]).toEqual(['100', '100', '120'])
  })

  test('keep all else; obstacles and rewards of the old map are gone', async () => {
    const railway = withMap(await newProject('Mine', 'railway'), 'map', row)
    const changed = learningOn(railway, 'map')
    const text = JSON.stringify(changed.programs)
    expect(text).toContain('"REWARDS":""')
    expect(text).not.toContain('OBSTACLE')
    expect(JSON.stringify(learningOn(changed, 'map'))).toBe(JSON.stringify(changed))
    expect({ ...changed, programs: railway.programs }).toEqual(railway)
    const without = withMap(friendship, 'map', row)
    expect(learningOn(without, 'map').programs).toEqual(without.programs)
  })
})

describe('a map is opened', () => {
  const withTwo = withMap(withMap(friendship, 'map', row), 'map-2', row)

  test('from the project that has it, and from no other', async () => {
    await save('mine', withTwo, 0)
    expect(await openMapOf('mine', 'map-2', 'New')).toEqual({
      id: 'mine',
      mapId: 'map-2',
      project: withTwo,
      revision: (await load('mine'))!.revision,
    })
    expect(await openMapOf('mine', 'other', 'New')).toBeNull()
    await save('plain', friendship, 0)
    expect(await openMapOf('plain', 'map', 'New')).toBeNull()
    expect(await openMapOf('nobody', 'map', 'New')).toBeNull()
  })

  test('as a new one under the first free name, which is not saved yet', async () => {
    await save('mine', withTwo, 0)
    await save('plain', friendship, 0)
    const third = (await openMapOf('mine', null, 'New'))!
    expect([third.mapId, third.project.maps!['map-3']!.name]).toEqual(['map-3', 'New'])
    expect(stationsOf(third.project)).toMatchObject({ map: 3, 'map-2': 3 })
    expect((await openMapOf('plain', null, 'New'))!.mapId).toBe('map')
    expect((await load('plain'))!.project.maps).toBeUndefined()
  })
})

describe('a drawing', () => {
  test('that was saved by the map designer opens as the same map', async () => {
    expect(await openDrawing(writeMap(row, 'map'), 'Other')).toEqual({
      ...{ map: row, warnings: [], pictureLost: false },
    })
  })

  test('that is none says why', async () => {
    expect(await openDrawing('no drawing', 'Other')).toMatchObject({ map: null })
  })

  test('with a picture that cannot be read keeps its roads', async () => {
    // A browser loads the picture; here it cannot.
    vi.stubGlobal('Image', class { src = ''; decode = () => Promise.reject(new Error('No picture.')) }) // prettier-ignore
    const svg = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 160 100"><path d="M1 1h9"/><circle id="node-0" cx="20" cy="50" r="5"/><circle id="node-1" cx="80" cy="50" r="5"/><path id="path-0-1" d="M20 50L80 50"/><path id="path-1-0" d="M80 50L20 50"/></svg>`
    const read = await openDrawing(svg, 'Other')
    expect(read).toMatchObject({ pictureLost: true, map: { name: 'Other', dress: 'meadow' } })
    expect(read.map).toMatchObject({ stations: [{ x: 200, y: 500 }, { x: 800, y: 500 }] }) // prettier-ignore
  })
})

test('maps that everybody has can be drawn on', async () => {
  expect(await startFrom('railway', 'Mine')).toMatchObject({ kind: 'roads', name: 'Mine' })
  expect(await startFrom('nowhere', 'Mine')).toBeNull()
})
