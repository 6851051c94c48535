// What makes, proves and keeps cards.
export { beginCard, cardsHere, openDraft, keepCard } from './model/cards.ts'
export { default as Maker } from './view/Maker.svelte'
export { default as Shelf } from './view/Shelf.svelte'
