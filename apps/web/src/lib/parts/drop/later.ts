export { takeDrops } from './drop.ts'
