import { paintFloor, type World } from '@botgarten/simulation'
import { cardConfig } from '@botgarten/simulation'
import { expect, it } from 'vitest'
import { honestBy } from './cages.ts'
import { countOf, isCage, learnIn, mending, rowsOf, shownIn, watchedIn, type SenseCage } from './index.ts'

const world: World = {
  size: { width: 300, height: 300 },
  ...{ floor: { colour: '#FFFFFF' }, areas: [], lines: [], obstacles: [] },
  robots: [
    { id: 'bo', program: 'main', brain: '', config: cardConfig, pose: { x: 150, y: 150, heading: 0 } },
  ],
}
const place = { worlds: [world], floor: paintFloor(world) }
const eye = (port: '2' | '3') => ({ port, mode: 'distance' }) as const
const cage: SenseCage = {
  ...{ id: 'spinner', world: 'small', starts: [{ x: 150, y: 150, heading: 0 }] },
  trial: {
    ...{
      sensors: [eye('2'), eye('3')],
      edges: [
        [15, 40],
        [15, 40],
      ],
      bump: true,
    },
    actions: [
      { left: 50, right: 50 },
      { left: -25, right: 25 },
      { left: 25, right: -25 },
    ],
    ...{ hold: 15, bumpEnds: false, alpha: 0.2, gamma: 0.9, rho: 0.3 },
    pay: [
      { for: 'moment', coins: 1 },
      { for: 'bump', coins: -1 },
    ],
  },
  cheats: { cm: [0, 60], bumps: [0, 0] },
  mend: [{ for: 'ahead', coins: 0.25 }],
}
const measured = { cm: 10, tiles: 1, touching: 0, bumps: 0, free: 0, near: 0, line: 0, ended: 0, pay: 240 }

it('what half of them do is a cage', () => {
  const bo = { seed: 1, mended: null, ...measured }
  const [one, other] = [
    { ...bo, cheats: true },
    { ...bo, cheats: false },
  ]
  expect([countOf([one, other]), isCage([one, other])]).toEqual([1, true])
  expect(isCage([one, other, other])).toBe(false)
})

it('an honest program drives far; without a bump it gets a coin for each of 240 moments', () => {
  const { measured: honest } = watchedIn(cage, place, honestBy(cage.trial))
  expect(honest.cm).toBeGreaterThan(400)
  expect(honest.pay).toBeCloseTo(240 - honest.bumps, 6)
})

it('rows are those of each seed, and the table that is shown is learned again from its own', () => {
  const rows = rowsOf(cage, place, 2)
  const { seed } = rows.shown
  const again = learnIn(cage, place, seed)
  expect(rows.bos[seed - 1]).toMatchObject({ seed, cheats: again.cheats, ...again.measured })
  expect(shownIn(cage, rows)).toEqual(again.table)
  expect(again.table.moves).toBe(1920)
})

it('says each minute of trying with another pay, and stops where it drives as is meant', () => {
  const tries = mending(cage, place, cage.mend, 1)
  const said: number[] = []
  for (;;) {
    const { done, value } = tries.next()
    if (done) {
      expect(said).toEqual(Array.from({ length: (value.minute ?? 9) - 1 }, (_, k) => k + 1))
      expect(value.table.pay).toEqual(cage.mend)
      break
    }
    said.push(value)
  }
})
