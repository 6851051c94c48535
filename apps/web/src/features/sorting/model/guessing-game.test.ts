import { expect, test } from 'vitest'
import { setOf } from '#figures/things/sets.ts'
import { GuessingGame } from './guessing-game.svelte.ts'

const vessels = setOf('vessels')

/** One child has chosen these features, and the other has seen all rounds. */
function sortedBy(...features: string[]): GuessingGame {
  const game = new GuessingGame(vessels)
  for (const feature of features) game.tick(feature)
  game.sort()
  for (let round = 0; round <= game.rounds.length; round++) game.next()
  return game
}

test('a feature is ticked, and unticked by a second press', () => {
  const game = new GuessingGame(vessels)
  for (const feature of ['width', 'height', 'width']) game.tick(feature)
  expect(game.secret).toEqual(['height'])
})

test('the sorting begins with a heap of all things and three empty trays, and ends with all of them on trays', () => {
  const game = new GuessingGame(vessels)
  game.tick('width')
  game.sort()
  expect([game.heap.length, game.groups]).toEqual([vessels.things.length, [[], [], []]])
  game.next()
  expect([game.heap, game.groups.flat().length]).toEqual([[], vessels.things.length])
})

test('behind the last round the other child is asked, and what was chosen in secret stays secret', () => {
  const game = sortedBy('width', 'height')
  expect([game.stage, game.ticked, game.groups]).toEqual(['guess', [], game.rounds.at(-1)])
})

test('a wrong guess shows how many were found, and can be tried again', () => {
  const game = sortedBy('width', 'height')
  for (const feature of ['width', 'colour']) game.tick(feature)
  game.check()
  expect([game.verdict, game.over]).toEqual([{ kind: 'wrong', found: 1, of: 2 }, false])
  game.tick('colour')
  expect(game.verdict).toBeNull()
  game.tick('height')
  game.check()
  expect([game.verdict?.kind, game.over]).toEqual(['right', true])
})

test('who gives up is shown the answer, and the children change places', () => {
  const game = sortedBy('width')
  game.show()
  expect([game.stage, game.over]).toEqual(['shown', true])
  game.swap()
  expect([game.stage, game.secret, game.guess, game.round, game.rounds]).toEqual(['choose', [], [], 0, []])
})
