// What a child meets only after a tap on the clock.
export { default as TimeBar } from './TimeBar.svelte'
export { default as ThenNote } from './ThenNote.svelte'
export { default as PastButtons } from './PastButtons.svelte'
export { default as Ghost } from '#figures/world/Ghost.svelte'
