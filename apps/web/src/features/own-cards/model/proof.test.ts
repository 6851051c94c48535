import { addBlocks } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { cardProject } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { draftOf, knobsAtZero } from '@botgarten/content/own-card'
import type { OwnCard, OwnProgram, Project } from '@botgarten/programs'
import { paintFloor } from '@botgarten/simulation'
import { afterEach, beforeAll, beforeEach, describe, expect, test, vi } from 'vitest'
import { screen } from '#lab/testing/session.ts'
import { Proof } from './proof.svelte.ts'

type Draft = Project & { readonly ownCard: OwnCard }

beforeAll(() => addBlocks(learning))
let draw: ReturnType<typeof screen>
beforeEach(() => {
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] })
  draw = screen()
})
afterEach(() => {
  vi.useRealTimers()
  vi.unstubAllGlobals()
})

const { card, world } = content.card('friendship')!
const solved = cardProject(world, card, content.program('friendship', 'solution')!, 'friendship')
const text = { title: 'Meet', story: 'A story.', task: 'Bo comes near.', hints: ['1', '2', '3'] as const }
const begun = draftOf(solved, 'Meet', 'en', card) as Draft
/** Friendship as a card that a teacher makes, at the first of its places; it is tried for a minute each time. */
const draft = (more: Partial<OwnCard> = {}): Draft => ({
  ...begun,
  ownCard: { ...begun.ownCard, text: { en: text }, starts: begun.ownCard.starts.slice(0, 1), ...more },
})

const floor = paintFloor({ ...world, floor: { colour: '#FFFFFF' } })
const turnedBack: OwnProgram = knobsAtZero(begun)

/** Follows a card until Bo has tried all of it. */
function triedOut(project: Draft): Proof {
  const proof = new Proof(floor)
  proof.follow(project)
  passes(proof)
  return proof
}

function passes(proof: Proof): void {
  vi.advanceTimersByTime(500)
  for (let frame = 0; proof.isTrying && frame < 1000; frame += 1) draw()
}

describe('a card that is being made', () => {
  test('is ready once its solution solves it everywhere, its start does not, and wrong answers are refused', () => {
    const wrong = [{ name: 'Nothing turns', ...turnedBack }]
    const proof = triedOut(draft({ starts: begun.ownCard.starts.slice(0, 2), wrong }))
    expect([proof.solved, proof.startSolves, proof.refused]).toEqual([[true, true], false, [true]])
    expect([proof.isTrying, proof.lack]).toEqual([false, null])
  })

  test('waits until the user is calm, and says that Bo is trying meanwhile', () => {
    const proof = new Proof(floor)
    expect([proof.lack, proof.solved, proof.refused]).toEqual(['trying', [], []])
    proof.follow(draft())
    vi.advanceTimersByTime(499)
    draw()
    expect([proof.solved, proof.startSolves, proof.isTrying, proof.lack]).toEqual([
      [null],
      null,
      true,
      'trying',
    ])
    passes(proof)
    expect(proof.lack).toBeNull()
  })

  test('without a check is not tried: nothing could come of it', () => {
    const proof = triedOut(draft({ checks: [] }))
    expect([proof.isTrying, proof.solved, proof.lack]).toEqual([false, [], 'checks'])
  })

  test('with one check is tried like every other', () => {
    const proof = triedOut(draft({ checks: begun.ownCard.checks.slice(0, 1) }))
    expect([proof.solved, proof.startSolves, proof.lack]).toEqual([[true], false, null])
  })

  test('lacks words before anything else', () => {
    expect(triedOut(draft({ text: {}, checks: [] })).lack).toBe('words')
  })

  test('whose program cannot run is not tried', () => {
    const empty = { ...draft(), programs: { main: { stacks: [], config: { stacks: [] } } } }
    const proof = triedOut(empty)
    expect([proof.isTrying, proof.lack]).toEqual([false, 'blocks'])
  })

  test('whose place is outside of the world does not fit it', () => {
    const starts = [{ x: world.size.width + 50, y: 20, heading: 0 }]
    expect(triedOut(draft({ starts })).lack).toBe('unfit')
  })
})

describe('a card is not ready', () => {
  test('while its program does not solve it', () => {
    const proof = triedOut({ ...draft({ start: turnedBack }), brains: turnedBack.brains })
    expect([proof.solved, proof.lack]).toEqual([[false], 'unsolved'])
  })

  test('where pupils begin with something that solves it already', () => {
    const proof = triedOut(draft({ start: { programs: begun.programs, brains: begun.brains } }))
    expect([proof.startSolves, proof.lack]).toEqual([true, 'start'])
    const { start: _, ...without } = draft().ownCard
    expect(triedOut({ ...draft(), ownCard: without }).lack).toBe('start')
  })

  test('where a wrong answer is accepted; the answers are told apart', () => {
    const wrong = [
      { name: 'Nothing turns', ...turnedBack },
      { name: 'Right', programs: begun.programs, brains: begun.brains },
    ]
    const proof = triedOut(draft({ wrong }))
    expect([proof.refused, proof.lack]).toEqual([[true, false], 'wrong'])
  })
})

test('only what has changed is tried again', () => {
  const proof = triedOut(draft())
  const two = draft({ starts: begun.ownCard.starts.slice(0, 2) })
  proof.follow(two)
  expect([proof.solved, proof.isTrying]).toEqual([[true, null], true])
  passes(proof)
  expect(proof.solved).toEqual([true, true])
  proof.follow(draft())
  expect(proof.isTrying).toBe(false)
})

test('a card that is closed is tried no further', () => {
  const proof = new Proof(floor)
  proof.follow(draft())
  proof.close()
  vi.advanceTimersByTime(1000)
  draw()
  expect(proof.isTrying).toBe(true)
  proof.follow(draft())
  vi.advanceTimersByTime(500)
  proof.close()
  for (let frame = 0; frame < 500; frame += 1) draw()
  expect(proof.solved).toEqual([null])
})
