// What loads a map and races on it.
export { openTrack } from './model/track.ts'
export { openCourse } from './model/brains/ground.ts'
export { default as Brains } from './view/brains/Brains.svelte'
export { default as Races } from './view/Races.svelte'
