import { untrack } from 'svelte'
import type { Packs } from '#lab/opening.ts'
import type { LabSession } from '#lab/session.svelte.ts'
import type { PupilLive } from '../live.svelte.ts'
import { kept } from './kept.ts'
import type { Together } from './together.svelte.ts'

/** Joins the pair that the open project belongs to, as soon as there is one. Returns how to end that. */
export function followPair(
  live: PupilLive,
  session: LabSession,
  packs: Packs,
  joined: (together: Together | null) => void,
): () => void {
  let together: Together | null = null
  let isComing = false
  let isGone = false
  const end = () => {
    together?.stop()
    together = null
    joined(null)
  }
  async function join(pair: string) {
    isComing = true
    const { Together } = await import('./together.svelte.ts')
    isComing = false
    if (isGone) return
    together = new Together(live, session, pair, packs, end)
    joined(together)
  }
  // The page goes: saving what was done in its last moment may not come to its end.
  const leave = () => together?.note()
  addEventListener('pagehide', leave)
  const stop = $effect.root(() => {
    $effect(() => {
      const { pair } = live
      if (!pair?.accepted || pair.over || together || isComing) return
      const own = kept()
      if (own?.pair === pair.id && own.project === session.autosave.id) untrack(() => void join(pair.id))
    })
  })
  return () => {
    isGone = true
    removeEventListener('pagehide', leave)
    stop()
    end()
  }
}
