import { beforeEach, expect, test, vi } from 'vitest'
import type { Highlight } from '#figures/highlight.svelte.ts'
import type { Viewport } from '#figures/world/viewport.svelte.ts'
import { Hand } from './hand.svelte.ts'
import type { WorldScene } from './scene.svelte.ts'
import { Touch } from './touch.ts'

const pose = { x: 50, y: 50, heading: 0 }
let pointed: (string | null)[]
let captured: number[]
let hand: Hand
let touch: Touch

/** A pane in which everything that is touched is the left motor of Bo. */
beforeEach(() => {
  pointed = []
  captured = []
  hand = new Hand(vi.fn())
  const viewport = { floorAt: (at: object) => at, push: vi.fn(), zoom: vi.fn() } as unknown as Viewport
  const scene = {
    ...{ selected: null, partAt: () => ({ id: 'bo', part: 'motor B' }) },
    grabbedAt: () => ({ kind: 'robot', id: 'bo', pose }),
  } as unknown as WorldScene
  const highlight = {
    touchPart: vi.fn(),
    pointAtPart: (part: string | null) => pointed.push(part),
  } as unknown as Highlight
  touch = new Touch({ viewport, hand, scene, highlight, shop: () => null })
})

const box = {
  setPointerCapture: (id: number) => captured.push(id),
  getBoundingClientRect: () => ({ left: 0, top: 0 }),
} as unknown as HTMLElement
const pointer = (more: Partial<PointerEvent>) =>
  ({
    ...{ pointerId: 7, pointerType: 'mouse', button: 0, buttons: 0, clientX: 50, clientY: 50 },
    ...{ stopPropagation: () => {}, ...more },
  }) as PointerEvent

test('a mouse without a button pressed points at a part; one that drags, or a finger, does not', () => {
  touch.move(pointer({ buttons: 1 }), box)
  touch.move(pointer({ pointerType: 'touch' }), box)
  touch.move(pointer({ pointerType: 'touch', buttons: 1 }), box)
  expect(pointed).toEqual([])
  touch.move(pointer({}), box)
  touch.leave()
  expect(pointed).toEqual(['motor B', null])
})

test('a finger that takes Bo holds it also where it leaves the pane', () => {
  touch.down(pointer({ pointerType: 'touch', buttons: 1 }), box)
  expect(captured).toEqual([7])
  expect(hand.selected).toBe('bo')
})
