// What is not there at once: what stands where there is no network or one that does not run.
export { default as Empty } from './Empty.svelte'
export { default as Loose } from './Loose.svelte'
