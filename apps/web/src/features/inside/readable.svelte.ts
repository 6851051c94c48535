import { calm } from '#drawing/calm.ts'
import type { Inside } from './inside.svelte.ts'

/** What the neurons say by their ids, a few times a second: what changes 60 times cannot be read. To be called while a component begins. */
export function readable(inside: () => Inside): { readonly now: { readonly [id: string]: number } } {
  const turn = calm(4)
  let now = $state.raw<{ readonly [id: string]: number }>({})
  $effect.pre(() => {
    const next = inside().trace?.outputs ?? {}
    if (turn(performance.now(), !inside().standing)) now = next
  })
  return {
    get now() {
      return now
    },
  }
}
