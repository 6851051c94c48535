import { isMap, type RoomMap } from '@botgarten/programs'
import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { readMap } from '../index.ts'
import { emptyRooms, endsOf, openMap, resizeRooms, roomKinds, setRoom, writeMap } from './index.ts'

const side = fc.integer({ min: 2, max: 12 })
const edit = fc.oneof(
  fc.record({ room: fc.nat(143), kind: fc.constantFrom(...roomKinds) }),
  fc.record({ columns: side, rows: side }),
)
const edited = fc.array(edit, { maxLength: 60 }).map((edits) =>
  edits.reduce<RoomMap>((map, one) => {
    if ('columns' in one) return resizeRooms(map, one.columns, one.rows)
    return setRoom(map, one.room % map.rows.join('').length, one.kind)
  }, emptyRooms('mine')),
)

test('whatever is done, a world of rooms stays one, and opens from its SVG as it was saved', () => {
  fc.assert(
    fc.property(edited, (map) => {
      expect(isMap(map)).toBe(true)
      const text = writeMap(map, 'mine')
      expect(openMap(text, 'other')).toEqual({ map, warnings: [], picture: null })
      const { start, goals } = endsOf(map)
      expect(readMap(text).map).toMatchObject({ start, goal: goals[0] })
    }),
    { seed: 2026 },
  )
})

describe('a tap on a room', () => {
  const lake = emptyRooms('lake')
  const row = (map: RoomMap) => map.rows[0]

  test('makes it what the tool says, and floor again', () => {
    const walled = setRoom(lake, 1, 'wall')
    expect([row(walled), row(setRoom(walled, 1, 'wall')), row(setRoom(walled, 1, 'ice'))]).toEqual(['SWFF', 'SFFF', 'SIFF']) // prettier-ignore
  })

  test('moves the start, and leaves a start and a treasure', () => {
    expect(row(setRoom(lake, 2, 'start'))).toBe('FFSF')
    for (const room of [0, 15]) expect(setRoom(lake, room, 'trap')).toBe(lake)
    expect(endsOf(setRoom(lake, 3, 'treasure')).goals).toEqual([3, 15])
  })

  test('lets wind blow through a column: a little, more, none', () => {
    const blown = (map: RoomMap) => setRoom(map, 6, 'wind')
    expect([blown(lake).wind, blown(blown(lake)).wind]).toEqual([[0, 0, 1, 0], [0, 0, 2, 0]]) // prettier-ignore
    expect(blown(blown(blown(lake)))).toEqual(lake)
  })
})

test('a room of ice slides as the frozen lake does: a third each ahead and to both sides (Gymnasium)', () => {
  const icy = setRoom(emptyRooms('ice', 3, 3), 4, 'ice')
  const left = readMap(writeMap(icy, 'ice')).map!.map.actions[4]![0]!
  expect(left.outcomes!.map(({ to }) => to)).toEqual([1, 3, 7])
  for (const { probability } of left.outcomes!) expect(probability).toBeCloseTo(1 / 3, 12)
  const { actions } = readMap(writeMap(icy, 'ice')).map!.map
  expect(actions[1]![1]!.outcomes).toEqual([{ probability: 1, to: 4 }])
})
