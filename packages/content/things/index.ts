export type * from '../schema/thingTypes.ts'
export { readThings } from '../schema/things.ts'
export { columnsOf, onPlane, rawOf } from './columns.ts'
