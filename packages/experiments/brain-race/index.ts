export type * from './types.ts'
export { billOf, type Bill } from './bill.ts'
export { finish, race, type Lane } from './race.ts'
export * from './table.ts'
