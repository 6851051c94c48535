// Deeper networks: what a child meets from the second level on, or with a net that has it already.
export { default as Brains } from './Brains.svelte'
export { partOf } from '#figures/network/deep/columns.ts'
export { default as Layers } from './Layers.svelte'
export { stepOf } from '#figures/network/deep/layout.ts'
export { default as NetSettings } from './NetSettings.svelte'
export { default as NeuronBar } from './NeuronBar.svelte'
export { columnsOf, layoutOf, seesOf, settle } from '#figures/network/deep/view.ts'
