export { default as Tour } from './Tour.svelte'
