// The sorting playground as a document. It is a part of a project, whose schema does not check it.
export * from './document.ts'
export { sortingIn } from './schema.ts'
