import { beforeEach, describe, expect, test } from 'vitest'
import type { Phase } from '#drawing/nudge.ts'
import { between } from '#drawing/points.ts'
import { freeLine, knobPlace } from '#drawing/track.ts'
import { Grab } from './grab.svelte.ts'

const tracks = [
  freeLine({ x: 0, y: 0 }, { x: 400, y: 0 }, 40),
  freeLine({ x: 0, y: 0 }, { x: 400, y: 200 }, 40),
  freeLine({ x: 0, y: 200 }, { x: 400, y: 0 }, 40),
]
let weights: number[]
let told: [number, number, Phase][]
let grab: Grab

beforeEach(() => {
  weights = [0.5, 0, 0]
  told = []
  grab = new Grab((link, weight, phase) => {
    told.push([link, weight, phase])
    weights[link] = weight
  })
})

describe('a finger on a knob', () => {
  test('grabs it alone; a finger far from all links grabs nothing', () => {
    const knob = knobPlace(tracks[0]!, 0.5)
    expect(grab.down(1, { x: knob.x, y: 1000 }, tracks, weights)).toBe(false)
    expect(grab.down(1, knob, tracks, weights)).toBe(true)
    expect(grab.down(2, knob, tracks, weights)).toBe(false)
  })

  test('that only touches it changes nothing', () => {
    const knob = knobPlace(tracks[0]!, 0.5)
    grab.down(1, { x: knob.x + 9, y: knob.y }, tracks, weights)
    grab.up(1)
    expect(told).toEqual([])
  })

  test('moves it to the nearest point of its line, also from far off, and says when it starts and ends', () => {
    const knob = knobPlace(tracks[0]!, 0.5)
    const aim = knobPlace(tracks[0]!, 0.8)
    grab.down(1, { x: knob.x + 9, y: knob.y }, tracks, weights)
    grab.move(1, { x: knob.x + 20, y: knob.y }, tracks, weights)
    grab.move(1, { x: aim.x + 9, y: aim.y + 150 }, tracks, weights)
    expect(grab.active).toBe(0)
    grab.up(1)
    expect(told[0]).toEqual([0, 0.5, 'start'])
    expect(told.at(-2)).toEqual([0, 0.8, 'move'])
    expect(told.at(-1)).toEqual([0, 0.8, 'end'])
    expect(grab.active).toBeNull()
  })

  test('on two knobs at one place takes the one whose link goes its way', () => {
    const middle = (0.5 - 0.12) / 0.7
    weights = [0, middle, middle]
    grab.down(1, { x: 200, y: 100 }, tracks, weights)
    expect(grab.active).toBeNull()
    grab.move(1, { x: 208, y: 96 }, tracks, weights)
    expect(grab.active).toBe(2)
  })

  test('is not disturbed by a second finger', () => {
    grab.down(1, knobPlace(tracks[0]!, 0.5), tracks, weights)
    expect(grab.down(2, knobPlace(tracks[1]!, 0), tracks, weights)).toBe(false)
    grab.move(2, { x: 300, y: 300 }, tracks, weights)
    grab.up(2)
    expect(told).toEqual([])
  })
})

test('a finger on a link away from its knob brings the knob there at once', () => {
  const place = between(tracks[0]!.from, tracks[0]!.to, 0.12 + 0.7 * 0.9)
  grab.down(1, place, tracks, weights)
  expect(told).toEqual([
    [0, 0.5, 'start'],
    [0, 0.9, 'move'],
  ])
})

test('a finger beside everything holds nothing', () => {
  expect(grab.down(1, { x: 200, y: 400 }, tracks, weights)).toBe(false)
})

test('a finger that began away from the knob slides it at once, however little it moves, and lets go of it', () => {
  const place = between(tracks[0]!.from, tracks[0]!.to, 0.12 + 0.7 * 0.9)
  grab.down(1, place, tracks, weights)
  // 5 px of a line of 400 px, whose knob goes over 70 % of it, are 0.018: slid by less than 4 px it is 0.01.
  grab.move(1, { x: place.x - 2.8, y: place.y }, tracks, weights)
  expect(told.at(-1)).toEqual([0, 0.89, 'move'])
  grab.up(1)
  expect(told.at(-1)).toEqual([0, 0.89, 'end'])
})
