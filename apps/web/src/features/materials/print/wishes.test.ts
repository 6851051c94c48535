import { expect, test } from 'vitest'
import { wishesIn } from './wishes.ts'

const here = 'https://botgarten.example.org/school/'
const read = (search: string) => wishesIn(new URLSearchParams(search), here)

test('where nothing is said: two on A4 over the short edge, codes lead to where this lab is', () => {
  expect(read('item=q-city')).toEqual({ paper: 'a4', turn: 'short', address: here })
})

test('everything can be said; an address gets its slash', () => {
  expect(read('paper=a5&turn=long&address=http://lab.local:4173')).toEqual({
    paper: 'a5',
    turn: 'long',
    address: 'http://lab.local:4173/',
  })
  expect(read('address=https://a.example/lab').address).toBe('https://a.example/lab/')
})

test.each(['address=', 'address=javascript:alert(1)', 'address=nonsense'])('%s: no code', (search) => {
  expect(read(search).address).toBeNull()
})
