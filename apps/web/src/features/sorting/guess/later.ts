export { default as Guess } from './Guess.svelte'
