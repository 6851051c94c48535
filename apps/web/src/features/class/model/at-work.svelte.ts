import { untrack } from 'svelte'
import { houseIdOf } from '#content/cards.ts'
import type { Packs } from '#lab/opening.ts'
import type { LabSession } from '#lab/session.svelte.ts'
import type { LabUi } from '#lab/ui.svelte.ts'
import type { PupilLive } from './live.svelte.ts'
import { reportOf } from './report.ts'
import { followPair } from './together/follow-pair.svelte.ts'
import type { Together } from './together/together.svelte.ts'

/** How many runs in a row have missed the same check first. */
export function countMissed(
  before: { readonly check: string; readonly times: number } | null,
  missed: string,
): { readonly check: string; readonly times: number } {
  return { check: missed, times: before?.check === missed ? before.times + 1 : 1 }
}

/** Lets the class know what happens in a lab, and stop it. Returns how to end that. */
export function follow(
  live: PupilLive,
  session: LabSession,
  ui: LabUi,
  packs: Packs,
  joined: (together: Together | null) => void,
): () => void {
  const card = session.opened.card?.card
  const id = houseIdOf(session.opened.card)
  let failed: ReturnType<typeof countMissed> | null = null
  let changedAt = Date.now()
  const stopListening = session.listen((event) => {
    if (event.kind === 'changed') changedAt = Date.now()
  })
  const stopTogether = followPair(live, session, packs, joined)
  const stopWatching = $effect.root(() => {
    $effect(() => {
      if (ui.missed) failed = countMissed(failed, ui.missed.check)
    })
    $effect(() => {
      if (session.lab.facts.succeeded) failed = null
    })
    $effect(() => {
      const isHeld = live.attention || live.closedPlace !== null
      if (isHeld && session.lab.facts.phase === 'running') untrack(() => session.lab.pause())
    })
  })
  const leave = live.work({
    place: id ?? 'free',
    get changedAt() {
      return changedAt
    },
    open: () => ({ id: session.autosave.id, project: session.project }),
    report: () =>
      reportOf({
        ...{ card: id, project: session.autosave.id },
        checks: card?.checks.map(({ id }) => id) ?? [],
        ...{ missed: ui.missed?.check ?? null, failed: failed?.times ?? 0 },
        ...{ size: session.lab.document.world.size, view: session.lab.view },
      }),
  })
  return () => (leave(), stopWatching(), stopListening(), stopTogether())
}
