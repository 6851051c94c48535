export { default as Inside } from './view/live/Inside.svelte'
