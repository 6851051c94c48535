export { sharesOf, type Shares } from './shares.ts'
export { roundTogether } from './rounding.ts'
export { aboveOf, fasterOf, signOf, smallestChange, type Change, type Decision } from './smallest.ts'
export { leaveOut } from './leave-out.ts'
