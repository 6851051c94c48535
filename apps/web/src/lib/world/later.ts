// What is seen once something in the world is selected.
export { default as TurnHandle } from './TurnHandle.svelte'
