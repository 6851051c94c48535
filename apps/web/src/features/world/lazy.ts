// The tools for building, and what a child meets after a tap on the clock.
import type { BuildMode } from './build-mode.svelte.ts'
import { Builder } from './building/builder.svelte.ts'

export { default as PastButtons } from './time/PastButtons.svelte'
export { default as ThenNote } from './time/ThenNote.svelte'
export { default as TimeBar } from './time/TimeBar.svelte'

/** The tools for building, with the floor as it is. */
export async function openWorkshop(mode: BuildMode): Promise<Builder> {
  const builder = new Builder(mode)
  await builder.open()
  return builder
}
