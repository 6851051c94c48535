import { expect, test } from 'vitest'
import { Resting } from './resting.ts'

const named = (...ids: readonly string[]) => ids.map((id) => ({ id }))

test('what stands from the beginning rests', () => {
  const all = named('a', 'b')
  expect(new Resting().split(all)).toEqual({ resting: all, moving: [] })
})

test('what moves is drawn apart until it has stood for half a second', () => {
  const resting = new Resting<{ id: string }>()
  const [a, b, moved] = named('a', 'b', 'a') as [{ id: string }, { id: string }, { id: string }]
  resting.split([a, b])
  for (let frame = 0; frame < 30; frame += 1) {
    expect(resting.split([moved, b])).toEqual({ resting: [b], moving: [moved] })
  }
  expect(resting.split([moved, b])).toEqual({ resting: [moved, b], moving: [] })
})

test('what rests is the same list for as long as nothing else rests', () => {
  const resting = new Resting<{ id: string }>()
  const b = { id: 'b' }
  resting.split([{ id: 'a' }, b])
  const first = resting.split([{ id: 'a' }, b]).resting
  expect(resting.split([{ id: 'a' }, b]).resting).toBe(first)
})
