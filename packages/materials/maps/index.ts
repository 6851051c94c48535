export type * from './types.ts'
export { readMap, type ReadMap } from './readMap.ts'
