export { default as PrintPage } from './PrintPage.svelte'
