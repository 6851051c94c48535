export { default as BuildDialog } from './build/BuildDialog.svelte'
export { default as Panel } from './panel/Panel.svelte'
export { default as Senses } from './senses/Senses.svelte'
