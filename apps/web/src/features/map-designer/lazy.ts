// What draws, opens and saves maps.
export { begin, learnOnGiven, openDrawing, openMapOf, ownMaps, startFrom } from './model/projects.ts'
export { default as Beginning } from './view/Beginning.svelte'
export { default as RoomMaker } from './view/RoomMaker.svelte'
export { default as MapDesigner } from './view/MapDesigner.svelte'
