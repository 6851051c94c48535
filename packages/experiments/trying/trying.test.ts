import { cardConfig, paintFloor, type World } from '@botgarten/simulation'
import type { Trial } from '@botgarten/learning/q-senses'
import { expect, test } from 'vitest'
import { tryOut } from './trying.ts'

const world: World = {
  size: { width: 4000, height: 4000 },
  floor: { colour: '#FFFFFF' },
  ...{ areas: [], lines: [], obstacles: [] },
  robots: [
    { id: 'bo', pose: { x: 2000, y: 2000, heading: 0 }, program: 'main', brain: '', config: cardConfig },
  ],
}
/** Its only action is to drive ahead: 5.6 π cm a second, 1,056 cm a minute. */
const trial: Trial = {
  ...{ sensors: [{ port: '2', mode: 'distance' }], edges: [[15, 40]], bump: true, bumpEnds: false },
  ...{ actions: [{ left: 50, right: 50 }], hold: 15, pay: [{ for: 'ahead', coins: 1 }] },
  ...{ alpha: 0.2, gamma: 0.9, rho: 0.2, seed: 1 },
}
const tried = (cm: number) => tryOut([world], paintFloor(world), trial, 2, { seconds: 2, cm })

test('a table counts as learned from the first minute after which it drives far enough', () => {
  expect(tried(1050)).toMatchObject({ first: 1, last: true })
  expect(tried(1060)).toMatchObject({ first: null, last: false })
})
