// What a program of many hundred blocks needs besides.

export { fillSlowly } from './fill.ts'
