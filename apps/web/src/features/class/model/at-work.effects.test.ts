import 'fake-indexeddb/auto'
import { flushSync } from 'svelte'
import { afterEach, expect, test, vi } from 'vitest'
import type { Packs } from '#lab/opening.ts'
import { closeSessions, screen, sessionOf } from '#lab/testing/session.ts'
import type { LabUi } from '#lab/ui.svelte.ts'
import { follow } from './at-work.svelte.ts'
import type { PupilLive, Work } from './live.svelte.ts'

afterEach(() => {
  closeSessions()
  vi.unstubAllGlobals()
})

/** A lab whose last run has missed this check, as its class sees it. */
function followed(missed: { readonly check: string } | null) {
  screen()
  vi.stubGlobal('addEventListener', () => {})
  vi.stubGlobal('removeEventListener', () => {})
  const { session } = sessionOf()
  const works: Work[] = []
  const leave = vi.fn()
  const work = (one: Work) => (works.push(one), leave)
  const live = { attention: false, closedPlace: null, pair: null, work } as unknown as PupilLive
  const end = follow(live, session, { missed } as LabUi, [] as unknown as Packs, () => {})
  flushSync()
  return { session, work: works[0]!, end, leave }
}

test('the class sees which check the last run has missed, and that it was one run', () => {
  const { session, work, end } = followed({ check: 'near' })
  const { failed, checks } = work.report()
  expect(failed).toBe(1)
  expect(checks).toEqual(
    session.opened.card!.card.checks.map(({ id }) => (id === 'near' ? 'failed' : 'open')),
  )
  end()
})

test('the class sees no failed run where none has missed a check', () => {
  const { work, end } = followed(null)
  expect(work.report()).toMatchObject({ failed: 0, running: false })
  end()
})

test('a lab that is left reports nothing more', () => {
  const { end, leave } = followed(null)
  expect(leave).not.toHaveBeenCalled()
  end()
  expect(leave).toHaveBeenCalledTimes(1)
})
