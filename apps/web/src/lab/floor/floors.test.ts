import { deflateSync } from 'node:zlib'
import { paintFloor } from '@botgarten/simulation'
import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { friendship } from '#storage/testing/sample.ts'
import { Floors } from './floors.ts'

const size = { width: 600, height: 400 }
const ours = { size, floor: friendship.world.floor, areas: [], lines: [] }
const plain = { ...ours, floor: { colour: '#00FF00' } }
/** One pixel of these three bytes of colour and one of none. */
const packed = () => deflateSync(new Uint8Array([0, 0, 0, 1, 0, 0, 0, 1, 255, 0, 0, 255]))
let fetched = 0

beforeEach(() => {
  fetched = 0
  vi.spyOn(console, 'warn').mockImplementation(() => {})
  vi.stubGlobal('fetch', () => {
    fetched += 1
    return Promise.resolve(new Response(packed()))
  })
})
afterEach(() => {
  vi.unstubAllGlobals()
  vi.restoreAllMocks()
})

test('the picture of a floor comes once, and is what is painted', async () => {
  const floors = new Floors()
  expect(await floors.load(ours, {})).toBe(true)
  expect(await floors.load(ours, {})).toBe(true)
  expect(fetched).toBe(1)
  const picture = { width: 1, height: 1, data: new Uint8Array([255, 0, 0, 255]) }
  expect(floors.paint(ours)).toEqual(paintFloor(ours, picture))
  expect(floors.paint(ours)).not.toEqual(paintFloor(ours))
})

test('a colour needs none', async () => {
  const floors = new Floors()
  expect(await floors.load(plain, {})).toBe(true)
  expect(fetched).toBe(0)
  expect(floors.paint(plain)).toEqual(paintFloor(plain))
})

test('one that is there already is not fetched; one that does not come is said, and asked for again', async () => {
  const floors = new Floors()
  vi.stubGlobal('fetch', () => Promise.reject(new TypeError('No network in a test.')))
  expect(await floors.load(ours, {})).toBe(false)
  expect(await floors.load({ floor: { asset: 'content:gone' } }, {})).toBe(false)
  const picture = { width: 1, height: 1, data: new Uint8Array([0, 0, 255, 255]) }
  floors.keep((ours.floor as { asset: string }).asset, picture)
  expect(await floors.load(ours, {})).toBe(true)
  expect(floors.paint(ours)).toEqual(paintFloor(ours, picture))
})
