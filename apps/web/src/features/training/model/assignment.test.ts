import 'fake-indexeddb/auto'
import { noExamples, withDrive } from '@botgarten/learning/neural-network/examples'
import { afterEach, expect, test } from 'vitest'
import { closeSessions, screen, sessionOf } from '#lab/testing/session.ts'
import { Assignment } from './assignment.svelte.ts'

afterEach(closeSessions)

/** Two rows of the card Friendship; the network has a left and a right eye and wheel. */
function assigned() {
  screen()
  const { session } = sessionOf()
  const shown = [[40, 40, 45, 45], [7, 90, 0, 80]].map(([a, b, l, r], tick) => ({
    ...{ tick: 60 * tick, pose: { x: 50, y: 50, heading: 0 } },
    ...{ inputs: [a!, b!], outputs: [l!, r!] },
  })) // prettier-ignore
  const none = noExamples(['eyeLeft', 'eyeRight'], ['wheelLeft', 'wheelRight'])
  const { examples } = withDrive(none, { id: 'pad-1', by: 'pad', seed: 1 }, shown)
  session.examples.replace(session.outlines[0]!.id, examples)
  return new Assignment(session)
}

test('with the mirror each example is practised twice, and without it once', () => {
  const assignment = assigned()
  assignment.choose({ mirror: false })
  const once = assignment.prepared!.data.practised.count
  expect(assignment.isMirrored).toBe(false)
  assignment.choose({ mirror: true })
  expect([assignment.isMirrored, assignment.prepared!.data.practised.count]).toEqual([true, 2 * once])
})

test('without examples nothing is practised, and no mirror image is', () => {
  screen()
  const assignment = new Assignment(sessionOf().session)
  expect([assignment.prepared?.data.practised.count ?? 0, assignment.isMirrored]).toEqual([0, false])
  expect(assignment.obstacle).toEqual({ kind: 'noRows' })
})
