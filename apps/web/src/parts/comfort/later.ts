export { default as ComfortDialog } from './ComfortDialog.svelte'
