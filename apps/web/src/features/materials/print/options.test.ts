import fc from 'fast-check'
import { expect, test } from 'vitest'
import { twoUp, type Turn, optionsIn } from './options.ts'

test('two cards stand on a sheet, and their backs on its other side', () => {
  expect(twoUp(4, 'short')).toEqual([
    [0, 2],
    [3, 1],
  ])
  expect(twoUp(4, 'long')).toEqual([
    [0, 2],
    [1, 3],
  ])
})

test('where cards are odd in number the last one is printed twice', () => {
  expect(twoUp(6, 'short').slice(2)).toEqual([
    [4, 4],
    [5, 5],
  ])
  expect(twoUp(2, 'long')).toEqual([
    [0, 0],
    [1, 1],
  ])
})

test('what has one side alone is printed twice beside each other, on one side of the paper', () => {
  expect(twoUp(1, 'short')).toEqual([[0, 0]])
})

/** Where light falls that shines through a place of the front: 0 left, 1 right. */
const behind: { readonly [turn in Turn]: (place: number) => number } = {
  short: (place) => 1 - place,
  long: (place) => place,
}

test('every side is printed, each back behind its front', () => {
  fc.assert(
    fc.property(fc.integer({ min: 2, max: 40 }), fc.constantFrom<Turn>('short', 'long'), (sides, turn) => {
      const pages = twoUp(sides, turn)
      const printed = new Set(pages.flat().filter((side) => side !== null))
      expect([...printed].sort((a, b) => a - b)).toEqual([...Array(sides).keys()])
      for (let sheet = 0; sheet < pages.length; sheet += 2)
        for (const place of [0, 1]) {
          const front = pages[sheet]![place as 0 | 1]
          const back = pages[sheet + 1]![behind[turn](place) as 0 | 1]
          if (back !== null) expect(back).toBe(front! + 1)
        }
    }),
    { seed: 1 },
  )
})

const here = 'https://botgarten.example.org/school/'
const read = (search: string) => optionsIn(new URLSearchParams(search), here)

test('where nothing is said: two on A4 over the short edge, codes lead to where this lab is', () => {
  expect(read('item=q-city')).toEqual({
    paper: 'a4',
    turn: 'short',
    address: here,
    grey: false,
  })
})

test('everything can be said; an address gets its slash', () => {
  expect(read('paper=a5&turn=long&grey=yes&address=http://lab.local:4173')).toEqual({
    paper: 'a5',
    turn: 'long',
    address: 'http://lab.local:4173/',
    grey: true,
  })
  expect(read('address=https://a.example/lab').address).toBe('https://a.example/lab/')
})

test.each(['address=', 'address=javascript:alert(1)', 'address=nonsense'])('%s: no code', (search) => {
  expect(read(search).address).toBeNull()
})
