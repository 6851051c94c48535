export { gridOf, readingsAt } from './field.ts'
export { imagine, type Imagined } from './imagine.ts'
export type { Standpoint } from './standpoint.ts'
