// What loads a map and races on it.
export { openTrack } from './model/track.ts'
export { default as Races } from './view/Races.svelte'
