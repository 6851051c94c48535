import type { Obstacle } from '@botgarten/simulation'
import { expect, test } from 'vitest'
import { drawShadow, drawThing } from './thing-looks.ts'

const thing = (look?: string): Obstacle => ({
  id: 'a',
  pose: { x: 0, y: 0, heading: 0 },
  shape: { kind: 'rectangle', width: 60, height: 15 },
  colour: '#3A7BD5',
  fixed: true,
  ...(look !== undefined && { look }),
})

test('a drawing made for one size is stretched to the size of the thing', () => {
  expect(drawThing(thing('crate'))).toMatchObject([{ kind: 'group', scale: [2, 0.5] }])
})

test('a thing without a look, or with a name that is none, is its shape in its colour', () => {
  for (const look of [undefined, 'constructor', 'castle'])
    expect(drawThing(thing(look))[0]).toMatchObject({ kind: 'rect', x: -30, y: -7.5, fill: '#3A7BD5' })
})

test('the shadow has the outline of the thing and no line of its own', () => {
  expect(drawShadow(thing('wall'))).toEqual([
    { kind: 'rect', x: -30, y: -7.5, width: 60, height: 15, round: 1.875, fill: '#3A2A20' },
  ])
})
