// What is not there at once: pulses while it runs, and what stands where there is no network or one that does not run.
export { default as Empty } from './Empty.svelte'
export { default as Loose } from './Loose.svelte'
export { default as Pulse } from '#figures/network/Pulse.svelte'
