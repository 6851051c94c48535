import { content } from '@botgarten/content/files'
import type { SenseCage } from '@botgarten/experiments/cages'
import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { freshLocalStorage } from '#storage/testing/local.ts'
import { openSenseCage } from './open.ts'

const looks = ({ trial }: SenseCage) =>
  trial.sensors.some(({ mode }) => mode !== 'distance' && mode !== 'touch')
const cages = content.senseCages.map(({ cage }) => cage)

beforeEach(() => {
  freshLocalStorage()
  // Pictures of floors come from the server.
  vi.stubGlobal('fetch', () => Promise.reject(new TypeError('No network in a test.')))
})
afterEach(() => void vi.unstubAllGlobals())

test.each(cages.filter((cage) => !looks(cage)))(
  'the cage $id opens with its world, in which the robot stands on each of its starts',
  async (cage) => {
    const work = (await openSenseCage(cage.id))!
    expect(work.cage).toEqual(cage)
    const { worlds, picture } = work.grounds
    expect(worlds.map(({ robots }) => robots.map(({ pose }) => pose))).toEqual(cage.starts.map((at) => [at]))
    expect([worlds[0]!.size, picture]).toEqual([content.world(cage.world)!.size, null])
  },
)

test.each(cages.filter(looks))(
  'the cage $id needs the picture of its floor: a sensor looks at it',
  async ({ id }) => {
    await expect(openSenseCage(id)).rejects.toThrow('No network in a test.')
  },
)

test('a cage that does not exist does not open', async () => {
  expect(await openSenseCage('dragon')).toBeNull()
})
