import { expect, test } from 'vitest'
import type { Results } from './answers.ts'
import { doneBy, matrixOf } from './matrix.ts'

const cards = [
  { id: 'chameleon', bed: 'network', starts: 3 },
  { id: 'fear', bed: 'network', starts: 2 },
  { id: 'railway', bed: 'q-learning', starts: 1 },
  { id: 'mars', bed: 'q-learning', starts: 0 },
] as const
const pupils: Results['pupils'] = [
  { id: '2', nickname: 'Zebra', done: { chameleon: 3, fear: 1 } },
  { id: '1', nickname: 'Ähre', done: { chameleon: 3, fear: 2, railway: 0, mars: 0 } },
]

test('a card is done from all its places, worked on where a project is there, else not yet', () => {
  const rows = matrixOf(cards, { pupils, free: null })
  expect(rows.map(({ nickname, done }) => [nickname, done])).toEqual([
    ['Ähre', 2],
    ['Zebra', 1],
  ])
  expect(rows[1]!.cells).toEqual([
    { kind: 'done' },
    { kind: 'working', passed: 1, of: 2 },
    { kind: 'notYet' },
    { kind: 'notYet' },
  ])
  expect(doneBy(rows, cards)).toEqual([2, 1, 0, 0])
})

test('a card that is not free today is a dot, and what was done stays done', () => {
  const [, zebra] = matrixOf(cards, { pupils, free: ['fear'] })
  expect(zebra!.cells.map(({ kind }) => kind)).toEqual(['done', 'working', 'closed', 'closed'])
})

test('a playground without goals is never done', () => {
  expect(matrixOf(cards, { pupils, free: null })[0]!.cells[3]).toEqual({ kind: 'working', passed: 0, of: 0 })
})

test('a card with one place is done from this place', () => {
  const railway = { id: '3', nickname: 'Otter', done: { railway: 1 } }
  expect(matrixOf(cards, { pupils: [railway], free: null })[0]!.cells[2]).toEqual({ kind: 'done' })
})
