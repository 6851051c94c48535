import { readFileSync } from 'node:fs'
import { content } from '@botgarten/content/files'
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest'
import { stageOf } from '#figures/map/testing/stage.ts'
import { screen } from '#lab/testing/session.ts'
import { freshLocalStorage } from '#storage/testing/local.ts'
import { CageWork } from './cage-work.svelte.ts'
import { notedOf } from './notes.ts'
import { openCage } from './open.ts'

let draw: ReturnType<typeof screen>
beforeEach(() => {
  freshLocalStorage()
  draw = screen()
})
afterEach(() => void vi.unstubAllGlobals())

function workOn(id: string): CageWork {
  const loaded = content.cages.find(({ cage }) => cage.id === id)!
  return new CageWork(loaded, stageOf(id, readFileSync(content.mapOfCage(id), 'utf8')))
}

// The contract test of the cages proves by value iteration that the fountain cheats as it is, and not at its solution.
const solution = 10

describe('the cage of the fountain', () => {
  test('is fixed by the pay that makes the wish come true, and by no other', () => {
    const work = workOn('fountain')
    expect([work.setting, work.works, work.mended, work.isSafe]).toEqual([20, false, false, false])
    work.set(30)
    expect([work.setting, work.works, work.mended]).toEqual([30, false, false])
    work.set(solution)
    expect([work.works, work.mended]).toEqual([true, true])
    expect(work.proved).toEqual({ aLot: 'wish', aLittle: 'wish' })
    expect(work.paid.pay[0]).toMatchObject({ for: 'station', reward: solution })
  })

  test('shows nothing of a walk that was learned with another pay, and can learn again at once', () => {
    const work = workOn('fountain')
    work.guessThat('never')
    work.learn()
    draw(0)
    draw(250)
    expect([work.playback.playing, work.watched!.outcome]).toEqual([true, 'never'])
    work.set(solution)
    expect([work.playback.playing, work.playback.made, work.playback.progress]).toEqual([false, 0, 0])
    expect([work.isOld, work.hasLearned]).toEqual([true, true])
    expect([work.watched, work.step, work.reason]).toEqual([null, null, null])
    // The walk belongs to the pay that it was learned with, and waits at its beginning.
    work.set(20)
    expect([work.isOld, work.watched!.outcome, work.playback.made]).toEqual([false, 'never', 0])
  })

  test('stays fixed once it was, also on the next visit', () => {
    const work = workOn('fountain')
    work.guessThat('never')
    expect(notedOf('fountain')).toEqual({ guess: 'never', mended: false })
    work.set(solution)
    work.set(30)
    expect([work.works, work.mended]).toEqual([false, true])
    const again = workOn('fountain')
    expect([again.guess, again.mended, again.setting, again.works]).toEqual(['never', true, 20, false])
  })

  test('is noted with the guess alone: without one nothing is', () => {
    const work = workOn('fountain')
    work.set(solution)
    expect(notedOf('fountain')).toBeNull()
    work.guessThat('wish')
    expect(notedOf('fountain')).toEqual({ guess: 'wish', mended: true })
  })

  test('is learned only after a guess; then Bo goes around the fountain and earns 20 on every visit', () => {
    const work = workOn('fountain')
    work.learn()
    expect([work.watched, work.step, work.reason]).toEqual([null, null, null])
    work.guessThat('wish')
    work.learn()
    const { outcome, goals, steps, reward } = work.watched!
    expect([outcome, goals, steps.length]).toEqual(['never', 0, 100])
    expect(reward).toBe(20 * steps.filter(({ to }) => to === 2).length)
    expect(work.playback.playing).toBe(true)
    draw(0)
    draw(250)
    expect(work.step).toEqual(steps[0])
    expect(work.isOld).toBe(false)
    expect(work.reason!.moves[0].isBest).toBe(false)
    work.set(solution)
    work.learn()
    expect([work.isOld, work.watched!.outcome, work.watched!.goals]).toEqual([false, 'wish', 1])
    expect(work.reason!.moves[0].isBest).toBe(true)
  })
})

test('a cage that is safe from the beginning counts as fixed once its pay was tried', () => {
  const work = workOn('safe-hill')
  expect([work.isSafe, work.works, work.mended]).toEqual([true, false, false])
  work.set(work.setting)
  expect(work.works).toBe(false)
  // Pay for exact nearness changes no best behaviour (Ng, Harada, Russell 1999), at any amount.
  work.set(60)
  expect([work.works, work.mended]).toEqual([true, true])
})

test('a cage that does not exist does not open', async () => {
  expect(await openCage('dragon')).toBeNull()
})
