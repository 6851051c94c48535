export * from './brain.ts'
export { net as learner } from './train/learner.ts'
