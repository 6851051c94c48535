import type { Pose } from '@botgarten/simulation'
import { beforeEach, describe, expect, test } from 'vitest'
import type { Phase } from '#drawing/nudge.ts'
import { Hand } from './hand.svelte.ts'

const pose: Pose = { x: 100, y: 100, heading: 30 }
let told: [string, Pose, Phase][]
let hand: Hand

beforeEach(() => {
  told = []
  hand = new Hand((...call) => told.push(call))
})

describe('a hand in the world', () => {
  test('that taps selects and moves nothing', () => {
    hand.grab('block', pose, 'move', 1, { x: 110, y: 95 })
    hand.move(1, { x: 110.5, y: 95 })
    hand.release(1)
    expect(hand.selected).toBe('block')
    expect(told).toEqual([])
  })

  test('that drags keeps hold of the place it took', () => {
    hand.grab('block', pose, 'move', 1, { x: 110, y: 95 })
    hand.move(1, { x: 130, y: 105 })
    expect(hand.dragging).toBe('block')
    hand.release(1)
    expect(told).toEqual([
      ['block', pose, 'start'],
      ['block', { x: 120, y: 110, heading: 30 }, 'move'],
      ['block', { x: 120, y: 110, heading: 30 }, 'end'],
    ])
    expect(hand.dragging).toBeNull()
  })

  test('that turns the handle turns the thing as far (rule 1: counter-clockwise)', () => {
    hand.grab('bo', pose, 'turn', 1, { x: 150, y: 100 })
    hand.move(1, { x: 100, y: 150 })
    hand.release(1)
    expect(told.at(-1)).toEqual(['bo', { ...pose, heading: 120 }, 'end'])
  })

  test('holds a thing that drives on where it wants it', () => {
    hand.grab('bo', pose, 'move', 1, { x: 100, y: 100 })
    hand.keep()
    expect(told).toEqual([])
    hand.move(1, { x: 110, y: 100 })
    hand.keep()
    expect(told.at(-1)).toEqual(['bo', { ...pose, x: 110 }, 'move'])
  })

  test('lets no second finger take over', () => {
    hand.grab('bo', pose, 'move', 1, { x: 100, y: 100 })
    hand.grab('block', pose, 'move', 2, { x: 0, y: 0 })
    hand.move(2, { x: 50, y: 50 })
    hand.release(2)
    expect(told).toEqual([])
    expect(hand.selected).toBe('bo')
  })
})
