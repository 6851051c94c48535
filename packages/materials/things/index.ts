export type * from './types.ts'
export { readThings } from './readThings.ts'
export { columnsOf, onPlane, rawOf } from './columns.ts'
