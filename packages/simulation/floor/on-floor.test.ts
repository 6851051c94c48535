import { expect, test } from 'vitest'
import { pose } from '../testing/worlds.ts'
import { COLOURS } from './colours.ts'
import { coloursOn } from './on-floor.ts'
import { paintFloor } from './paint.ts'

const bare = { size: { width: 100, height: 50 }, floor: { colour: '#FFFFFF' }, lines: [] } as const
const patch = (id: string, width: number, colour: `#${string}`, x = 50) => ({
  ...{ id, colour, pose: pose(x, 25) },
  shape: { kind: 'rectangle', width, height: 20 } as const,
})

test('the colours on a floor are those that a sensor names there, the largest area first', () => {
  const areas = [patch('green', 20, COLOURS.green, 20), patch('yellow', 40, COLOURS.yellow, 70)]
  expect(coloursOn(paintFloor({ ...bare, areas }))).toEqual([COLOURS.white, COLOURS.yellow, COLOURS.green])
  expect(coloursOn(paintFloor({ ...bare, areas: [] }))).toEqual([COLOURS.white])
})

test('a colour without a name is no colour of the floor, nor is a speck smaller than a thousandth of it', () => {
  const speck = {
    ...patch('speck', 1, COLOURS.red),
    shape: { kind: 'rectangle', width: 1, height: 1 } as const,
  }
  expect(coloursOn(paintFloor({ ...bare, areas: [patch('pink', 60, '#FF99CC'), speck] }))).toEqual([
    COLOURS.white,
  ])
})
