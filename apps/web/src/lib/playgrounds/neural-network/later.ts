// What is not there at once: pulses while it runs, and what stands where there is no network.
export { default as Empty } from './Empty.svelte'
export { default as Pulse } from './Pulse.svelte'
