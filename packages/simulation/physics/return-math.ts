import { native } from './lend-math.ts'

Object.assign(Math, native)
