// What draws, opens and saves maps.
export { Designer } from './model/designer.svelte.ts'
export { begin, openDrawing, openMapOf, ownMaps, startFrom, type OpenedDrawing } from './model/projects.ts'
export { default as MapDesigner } from './view/MapDesigner.svelte'
