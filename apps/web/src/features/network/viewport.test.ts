import { expect, test } from 'vitest'
import { Viewport } from './viewport.svelte.ts'

test('scrolling is seen in steps: the same step is the same place', () => {
  const viewport = new Viewport()
  viewport.look({ scrollLeft: 0, scrollTop: 0 } as Element)
  const first = viewport.at
  viewport.look({ scrollLeft: 1, scrollTop: 1 } as Element)
  expect(viewport.at).toBe(first)
  viewport.look({ scrollLeft: 5000, scrollTop: 0 } as Element)
  expect(viewport.at).not.toBe(first)
  expect([viewport.at.x > 0, viewport.at.y]).toEqual([true, 0])
})
